#pragma once

#include "core/engine/session/snapshot.hpp"
#include "core/teaching/moment/moment.hpp"

#include <optional>
#include <string>

namespace forefront {

/// Returns the result of a step: "3 of 14 in 6 cells"; empty while unknown.
std::string stepFinding(const Moment &moment, Step step);

/// Returns the step that a run is at; none before the first run and between advances.
std::optional<Step> liveStep(const SessionSnapshot &run, const Moment &moment);

} // namespace forefront
