#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesh/tri_mesh.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/engine/session/breakpoints.hpp"
#include "core/engine/session/session_mode.hpp"
#include "core/engine/session/snapshot.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace FOREFRONT_API forefront {

/// The triangles that a front has made, in order. A two-coloured front makes the halves of squares.
struct FrontTriangles {
    std::vector<Vec2> nodes;
    std::vector<Element> elements;     ///< counter-clockwise
    std::vector<std::uint8_t> colours; ///< per node, 0 or 1; empty for a front of triangles
};

/// A meshing run that moves forward and back, one advance of the front at a time. Every call does its work on the
/// calling thread and returns when it is done; MeshingSession does the same on a thread of its own.
///
/// The state at a position does not depend on the way there, and a finished run has the mesh of meshDomain(). Use each
/// stepper from one thread at a time. If a callback of the job or of a Progress throws, the exception reaches the
/// caller and the run is discarded: the stepper is then empty(), and its other members must not be called.
class MeshStepper {
  public:
    /// Prepares a run before its first advance. A job of more than about `budget` elements is coarsened to it, see
    /// prepare(). Errors: those of prepare(), "out-of-memory".
    static Result<MeshStepper> create(MeshingJob job, const Progress &progress = {},
                                      double budget = std::numeric_limits<double>::infinity());
    MeshStepper(MeshStepper &&) noexcept;
    MeshStepper &operator=(MeshStepper &&) noexcept;
    ~MeshStepper();

    /// Returns true if the run was discarded because a callback threw, or moved to another stepper.
    bool empty() const;
    /// Returns the number of advances done at this position.
    std::uint64_t position() const;
    /// Returns the furthest position reached so far.
    std::uint64_t known() const;
    /// Returns true once the end of the run has been reached; known() is then the end.
    bool complete() const;
    /// Returns true at the end of the run, where the front is empty.
    bool atEnd() const;

    /// Moves `count` advances forward, or fewer at the end of the run, and returns their number.
    std::uint64_t advance(std::uint64_t count = 1);
    /// Moves `count` advances back, or fewer at the start, and returns their number.
    std::uint64_t retreat(std::uint64_t count = 1);
    /// Moves to a position, or to the end if that comes first. Positions beyond the known ones are computed. Returns
    /// false if it was cancelled on the way.
    bool seek(std::uint64_t position, const Progress &progress = {});
    /// Makes the steps of the improvement follow the last advance: seek(), step() and finish() move through them, in
    /// positions beyond known(), and reaching the end of the front improves the mesh. position() stays a number of
    /// advances; SessionSnapshot::improveStep has the step. To be called before the first move.
    void stepImprovement();
    /// Moves to the end of the run and, once, improves the mesh. Returns false if it was cancelled, or stopped because
    /// the mesh exceeds MeshingOptions::maxElements.
    bool finish(const Progress &progress = {});
    /// Moves n steps, back if negative, but not beyond a condition of stopAt().
    void step(Granularity granularity, std::int64_t n);
    /// Sets the conditions that stop step() and seekStop().
    void stopAt(const Breakpoints &breakpoints);
    /// Moves, back or forward, to the next advance that fulfils a condition of stopAt(), or as far as the run goes.
    /// Returns the condition; none if there is no such advance or the move was cancelled.
    std::optional<Stop> seekStop(bool forward, const Progress &progress = {});
    /// Moves to the advance that made the node or edge within `tolerance` of a place, or the element around it. Where
    /// nothing is made yet, moves forward until an element covers the place. Returns what it found among the parts made
    /// before the call; none also if it was cancelled.
    std::optional<Birth> seekBirth(Vec2 place, double tolerance, const Progress &progress = {});

    /// Returns the segments of the front Γ, each with the unmeshed part on its left.
    std::vector<FrontSegmentView> front();
    /// Returns the mesh at this position; at the end, the improved one if finish() has made it. A partial mesh has all
    /// nodes and edges of the boundary.
    Mesh mesh();
    /// Returns the triangles that the front has made at this position. The explanations of advances refer to them by
    /// number; those of quadrilaterals are halves, which mesh() joins.
    FrontTriangles triangles() const;
    /// Returns an explanation of the last advance, by doing it again; null before the first one.
    std::shared_ptr<const AdvanceExplanation> explanation();
    /// Returns the work counters at this position.
    const WorkCounters &statistics() const;
    /// Returns everything about this position in one structure, as MeshingSession publishes it.
    std::shared_ptr<const SessionSnapshot> snapshot(SnapshotLayers layers = {});

  private:
    struct Run;
    explicit MeshStepper(std::unique_ptr<Run> run);
    std::unique_ptr<Run> run_;
};

} // namespace forefront
