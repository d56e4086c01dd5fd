#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/session/snapshot.hpp"
#include "core/teaching/lesson/lesson.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace forefront {

// What can be wrong with a position of a lesson. The faults are errors without a place.

/// Returns the fault of a position beyond the end of a run with this many advances and steps of the improvement.
std::optional<Diagnostic> beyondEnd(const LessonPosition &position, std::uint64_t advances, std::size_t improveSteps);
/// Returns the fault of a position with more events than its advance has. `there`: where the run was led by it.
std::optional<Diagnostic> tooManyEvents(const LessonPosition &position, const SessionSnapshot &there);

} // namespace forefront
