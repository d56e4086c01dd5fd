#pragma once

#include "core/base/api.hpp"
#include "core/base/diagnostic.hpp"
#include "core/mesh/mesh.hpp"
#include "core/mesh/quality.hpp"
#include "core/mesher/statistics.hpp"
#include "core/mesher/trace.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace FOREFRONT_API forefront {

class SpacingField;
struct DiscreteDomain;

enum class RunState : std::uint8_t {
    Empty,     ///< nothing has been started
    Preparing, ///< validating, building ρ, discretising
    Running,   ///< playing or running to the end
    Paused,    ///< somewhere on the timeline
    Improving, ///< Γ = ∅; swapping and smoothing
    Finished,  ///< at the end, mesh complete
    Cancelled, ///< stopped by the user; the partial mesh stays and can be stepped
    Failed     ///< refused, and there was no run before: see diagnostics
};

/// What a snapshot shall carry besides the numbers; copied on demand only.
struct SnapshotLayers {
    bool mesh = true;
    bool front = true;
    bool cells = false;
    bool explanation = false; ///< of the advance at the cursor: candidates, tests, cells, caption

    friend bool operator==(const SnapshotLayers &, const SnapshotLayers &) = default;
};

struct FrontSegmentView {
    Vec2 a, b;
    NodeId nodeA = kNoNode, nodeB = kNoNode;
};

struct GridCellView {
    Box2 box;
    std::uint32_t entries = 0; ///< segments of Γ registered in the cell
};

enum class MarkKind : std::uint8_t { NewNode, Closure, Deferral, Forced };

/// A mark on the timeline.
struct TimelineMark {
    std::uint64_t advance = 0;
    MarkKind kind = MarkKind::Closure;
};

/// The mesh of a moment; shared, immutable. A partial mesh holds all boundary nodes and edges.
struct MeshView {
    Mesh mesh;
    std::vector<float> alpha;  ///< per element
    std::uint64_t version = 0; ///< changes whenever the content does
};

/// An immutable picture of the session, handed to the drawing thread.
struct SessionSnapshot {
    std::uint64_t sequence = 0; ///< grows with each snapshot
    std::uint64_t run = 0;      ///< number of the run (start() calls)
    std::uint64_t shownRun = 0; ///< of the mesh and the timeline: an earlier one while `run` is prepared or if refused
    RunState state = RunState::Empty;
    Diagnostics diagnostics;   ///< why `run` was refused
    std::string stage;         ///< "discretising", "advancing the front", "improving", ...
    double progress = 0.0;     ///< of the stage, in [0, 1]; an estimate while the front advances
    std::uint64_t advance = 0; ///< position on the timeline: advances done
    std::uint64_t known = 0;   ///< furthest advance reached so far
    bool complete = false;     ///< the whole run is known: `known` is the end of the timeline
    bool improved = false;     ///< the mesh shown is the improved one (only at the end)
    /// Moment of the explanation on show: an index into its events, or eventCount for the whole advance.
    std::size_t eventCursor = 0;
    std::size_t eventCount = 0;
    double rate = 0.0;    ///< advances per second of the last batch
    bool playing = false; ///< at a pace that the user set, rather than as fast as possible
    WorkCounters work;
    MeshQuality quality; ///< of the mesh shown
    std::size_t frontSegments = 0;
    std::uint64_t stateHash = 0;                    ///< of front and mesh at this position; 0 while moving
    std::uint64_t meshHash = 0;                     ///< set when complete
    double secondsMesh = 0.0, secondsImprove = 0.0; ///< CPU time, of all threads that took part
    std::shared_ptr<const DiscreteDomain> boundary;
    std::shared_ptr<const SpacingField> spacing;
    std::shared_ptr<const MeshView> mesh;
    std::shared_ptr<const std::vector<FrontSegmentView>> front;
    std::shared_ptr<const std::vector<GridCellView>> cells;
    std::shared_ptr<const AdvanceExplanation>
        explanation; ///< of the last advance done (or the one under the event cursor)
    std::shared_ptr<const std::vector<TimelineMark>> marks; ///< at most some thousand, thinned out evenly
};

} // namespace forefront
