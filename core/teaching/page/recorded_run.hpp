#pragma once

#include "core/engine/mesh/mesh.hpp"
#include "core/engine/mesher/trace.hpp"
#include "core/engine/session/mesh_stepper.hpp"
#include "core/engine/session/snapshot.hpp"
#include "core/teaching/page/recorded_improvement.hpp"
#include "core/teaching/page/run_page.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace forefront {

/// The steps of a run, as far as a page plays them.
struct RecordedRun {
    MeshingOptions options;              ///< of the job
    Mesh start;                          ///< before the first advance
    std::vector<FrontSegmentView> front; ///< before the first advance
    std::vector<std::shared_ptr<const AdvanceExplanation>> advances;
    Mesh mesh;                         ///< after the last one, not improved
    FrontTriangles triangles;          ///< made by them
    bool complete = false;             ///< they end with the run
    std::optional<Mesh> improved;      ///< the finished mesh, if the run is complete and more follows on the front
    RecordedImprovement improvement{}; ///< the steps that lead to it

    /// Returns true if the front is one of two colours, which makes halves of squares.
    bool isColoured() const { return !triangles.colours.empty(); }
    /// Returns the number of moments after the front, the last of which shows the improved mesh.
    std::size_t improveMoments() const { return improved ? improvement.moments() : 0; }
};

/// Runs a job and keeps its steps. Faults: those of writeRunPage().
Result<RecordedRun> recordRun(const MeshingJob &job, const RunPagePlan &plan, const Progress &progress);
/// Does the same with a stepper of a job with these options, whose elements are of first order. Leaves it anywhere.
Result<RecordedRun> recordRun(MeshStepper &stepper, const MeshingOptions &options, const RunPagePlan &plan,
                              const Progress &progress);

/// Writes a run as the player reads it: JSON that can stand in a script element. `from`: number of advances done when
/// the player opens. `detailed`: per advance, whether its candidates, tests and cells are written, and not its elements
/// alone; empty: those of all.
void writeRun(TextWriter &out, const RecordedRun &run, const std::string &title, std::uint64_t from,
              const std::vector<bool> &detailed = {});
/// Does the same in two parts: all but the steps of the improvement, and these with the end of the text. `improvement`:
/// null if the run is not improved.
void writeRunWithoutSteps(TextWriter &out, const RecordedRun &run, const std::string &title, std::uint64_t from,
                          const std::vector<bool> &detailed = {});
void writeSteps(TextWriter &out, const RecordedImprovement *improvement);

/// Returns text as a JSON string that cannot end the script element that it is in.
std::string scriptString(const std::string &text);
/// Returns text as the content of an HTML element.
std::string htmlText(const std::string &text);

} // namespace forefront
