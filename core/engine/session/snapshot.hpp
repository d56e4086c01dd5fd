#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/improve/improve_step.hpp"
#include "core/engine/layers/layer_report.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesh/second_order.hpp"
#include "core/engine/mesh/triangulated.hpp"
#include "core/engine/mesher/statistics.hpp"
#include "core/engine/mesher/trace.hpp"
#include "core/engine/refine/least_angle.hpp"
#include "core/engine/session/breakpoints.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace FOREFRONT_API forefront {

class SpacingField;
struct DiscreteDomain;

/// The state of a run.
enum class RunState : std::uint8_t {
    Empty,     ///< nothing has been started
    Preparing, ///< validating, building the spacing, discretising
    Running,   ///< playing or running to the end
    Paused,    ///< at a position of the timeline
    Improving, ///< Γ = ∅; swapping and smoothing
    Finished,  ///< at the end, mesh complete
    Cancelled, ///< stopped by the user; the partial mesh remains and can be stepped through
    Failed     ///< the first job was refused; see diagnostics
};

/// The layers of a snapshot, which are copied only on request.
struct SnapshotLayers {
    bool mesh = true;
    bool front = true;
    bool cells = false;
    bool explanation = false; ///< of the advance at the cursor: candidates, tests, cells, caption

    friend bool operator==(const SnapshotLayers &, const SnapshotLayers &) = default;
};

/// A segment of Γ.
struct FrontSegmentView {
    Vec2 a, b;
    NodeId nodeA = kNoNode, nodeB = kNoNode;
    int colour = -1; ///< of A in a two-coloured front: 0 or 1; -1: none
};

/// A cell of the background grid.
struct GridCellView {
    Box2 box;
    std::uint32_t entries = 0; ///< segments of Γ registered in the cell
};

/// The kind of a mark on the timeline.
enum class MarkKind : std::uint8_t {
    NewNode,
    Rejection,  ///< a candidate was tested and rejected
    Connection, ///< two places of Γ were connected: two loops became one, or one became two
    Closure,    ///< the last element of a loop
    Deferral,   ///< no candidate passed
    Forced      ///< made by the closing stage
};
inline constexpr std::size_t kMarkKinds = 6;

/// A mark on the timeline.
struct TimelineMark {
    std::uint64_t advance = 0;
    MarkKind kind = MarkKind::Closure;
};

/// The run from the start to the furthest advance, in at most RunCurves::kSamples intervals of equal length.
struct RunCurves {
    static constexpr std::size_t kSamples = 512;
    /// The means over an interval.
    struct Sample {
        float front = 0.0F;                      ///< segments of Γ
        float tests = 0.0F;                      ///< segments tested for intersection per element; 0 without an element
        float alphaMean = 0.0F, alphaMin = 0.0F; ///< of its elements; both 1 without an element
    };
    std::uint64_t advancesPerSample = 1; ///< the last sample may have fewer
    std::vector<Sample> samples;
};

/// An immutable, shared mesh with the triangles by which it is drawn. A partial mesh has all boundary nodes and edges.
struct MeshSnapshot : Triangulated {
    std::shared_ptr<const Mesh> whole; ///< the mesh, if it has other elements than triangles of 3 nodes; else null
    std::vector<float> alpha;          ///< per element of view()
    std::uint64_t version = 0;         ///< changes whenever the content does

    /// Returns the mesh.
    MeshView view() const { return whole ? MeshView(*whole) : MeshView(mesh); }
};

/// Returns a snapshot of a mesh, with its α, whose version is yet to be set.
std::shared_ptr<MeshSnapshot> snapshotOf(Mesh mesh);

/// An immutable copy of the state of a session for the UI thread.
struct SessionSnapshot {
    std::uint64_t sequence = 0; ///< grows with each snapshot
    std::uint64_t run = 0;      ///< number of the run (start() calls)
    std::uint64_t shownRun =
        0; ///< run of the mesh and the timeline: the previous one while `run` is prepared or if it is refused
    RunState state = RunState::Empty;
    Diagnostics diagnostics;   ///< why `run` was refused
    std::string stage;         ///< "discretising", "advancing the front", "improving", ...
    double progress = 0.0;     ///< of the stage, in [0, 1]; an estimate while the front advances
    std::uint64_t advance = 0; ///< position on the timeline: advances done
    std::uint64_t known = 0;   ///< furthest advance reached so far
    bool complete = false;     ///< `known` is the end of the run
    bool improved = false;     ///< the mesh shown is the improved one (only at the end)
    /// Steps of the improvement done, which follow the last advance, and their number; 0 before it is reached first.
    std::size_t improveStep = 0, improveSteps = 0;
    /// The step of the improvement that led here; null before the first one, and at the end unless stepped there.
    std::shared_ptr<const ImproveStep> improvement;
    /// The moment of the explanation: an index into its events, or eventCount for the whole advance.
    std::size_t eventCursor = 0;
    std::size_t eventCount = 0;
    std::optional<Stop> stop;   ///< at rest: the breakpoint that ended the last move
    std::optional<Birth> birth; ///< at rest: the answer to seekBirth(), if it found something made already
    double rate = 0.0;          ///< advances per second of the last batch
    bool playing = false;       ///< at a pace that the user set, rather than as fast as possible
    WorkCounters work;
    MeshQuality quality;                                ///< of the mesh shown
    std::shared_ptr<const SecondOrderReport> order;     ///< of the mesh shown; null: of first order, or not finished
    std::shared_ptr<const LeastAngleReport> leastAngle; ///< likewise; null: none was asked for
    std::shared_ptr<const LayerReport> layers;          ///< of the boundary layers of the job; null: none
    double requestedElements = 0.0;                     ///< estimate for the spacing of the job; see prepare()
    double coarsening = 1.0; ///< > 1: the mesh shown is a preview with this many times the spacing of the job
    std::size_t frontSegments = 0;
    std::uint64_t stateHash = 0;                    ///< of front and mesh at this position; 0 while moving
    std::uint64_t meshHash = 0;                     ///< set when complete
    double secondsMesh = 0.0, secondsImprove = 0.0; ///< CPU time of all threads
    std::shared_ptr<const DiscreteDomain> boundary;
    std::shared_ptr<const SpacingField> spacing;
    std::shared_ptr<const MeshSnapshot> mesh;
    std::shared_ptr<const std::vector<FrontSegmentView>> front;
    std::shared_ptr<const std::vector<GridCellView>> cells;
    std::shared_ptr<const AdvanceExplanation>
        explanation; ///< of the last advance, or of the one that contains the event cursor
    /// By advance, at most 2000 of each kind: one for each interval of the timeline that has any.
    std::shared_ptr<const std::vector<TimelineMark>> marks;
    std::shared_ptr<const RunCurves> curves;

    /// Returns true once the front is empty at this position: the mesh is that of the front, or improved.
    bool frontDone() const { return complete && advance == known; }
    /// Returns true at the end of the run, after the improvement.
    bool atEnd() const { return frontDone() && improveStep == improveSteps; }
    /// Returns the position on the timeline and its length: advances, then steps of the improvement.
    std::uint64_t position() const { return advance + improveStep; }
    std::uint64_t length() const { return known + improveSteps; }
};

} // namespace forefront
