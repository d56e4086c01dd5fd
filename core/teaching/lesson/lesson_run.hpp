#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/session/mesh_stepper.hpp"
#include "core/teaching/lesson/lesson.hpp"

#include <cstdint>
#include <memory>
#include <optional>

namespace forefront {

/// The run of a page without a window. Its length is known from the start.
class LessonRun {
  public:
    /// Runs the drawing of a page, which must have one, to its end. Errors: those of the job, "cancelled".
    static Result<LessonRun> create(const LessonPage &page, const Progress &progress);

    /// Returns the number of advances, and of the steps of the improvement that follow them.
    std::uint64_t advances() const { return advances_; }
    std::size_t improveSteps() const { return improveSteps_; }

    /// Returns what the run shows at a position, or as near to it as the run and the advance go. `mesh`: with the mesh,
    /// whose figures are then complete.
    std::shared_ptr<const SessionSnapshot> at(const LessonPosition &position, bool mesh = true);

  private:
    explicit LessonRun(MeshStepper stepper) : stepper_(std::move(stepper)) {}

    MeshStepper stepper_;
    std::uint64_t advances_ = 0;
    std::size_t improveSteps_ = 0;
};

/// Returns true if two pages show the same run.
bool sameRun(const LessonPage &a, const LessonPage &b);

} // namespace forefront
