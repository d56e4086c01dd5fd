#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/session/mesh_stepper.hpp"
#include "core/teaching/lesson/lesson.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

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

    /// Returns the stepper, which may be moved anywhere, and the options of its job.
    MeshStepper &stepper() { return stepper_; }
    const MeshingOptions &options() const { return options_; }

  private:
    LessonRun(MeshStepper stepper, const MeshingOptions &options) : stepper_(std::move(stepper)), options_(options) {}

    MeshStepper stepper_;
    MeshingOptions options_;
    std::uint64_t advances_ = 0;
    std::size_t improveSteps_ = 0;
};

/// Returns true if two pages show the same run.
bool sameRun(const LessonPage &a, const LessonPage &b);

/// The runs of the pages of a lesson, so that no drawing is run twice in a row.
class LessonRuns {
  public:
    enum class Keep : std::uint8_t { Last, All };

    explicit LessonRuns(Keep keep = Keep::Last) : keep_(keep) {}

    /// Returns the run of a page, which must have a drawing. Errors: those of LessonRun::create().
    Result<std::shared_ptr<LessonRun>> of(const LessonPage &page, const Progress &progress);
    /// Returns the number of runs made so far.
    std::size_t made() const { return made_; }

  private:
    Keep keep_;
    std::vector<std::pair<LessonPage, std::shared_ptr<LessonRun>>> runs_;
    std::size_t made_ = 0;
};

} // namespace forefront
