#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/mesh/mesh.hpp"
#include "core/engine/mesher/checkpoint.hpp"
#include "core/engine/mesher/front_state.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/engine/mesher/trace.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace forefront {

/// The nodes and elements of a run up to the furthest advance reached.
struct MadeSoFar {
    std::vector<Vec2> nodes;
    std::vector<Element> elements;
    std::vector<std::uint32_t> elementFaces; ///< as FrontState::elementFaces

    /// Appends the nodes and elements that a state has beyond these.
    void add(const FrontState &state);
};

/// A run of the front over a discretised domain, independent of its method and background grid. It pauses between
/// advances and costs one virtual call for each batch of advances.
class Mesher {
  public:
    /// Creates a run. `boundary` and `spacing` must come from prepare() or from a validated domain.
    static std::unique_ptr<Mesher> create(std::shared_ptr<const DiscreteDomain> boundary,
                                          std::shared_ptr<const SpacingField> spacing, const MeshingOptions &options);
    virtual ~Mesher() = default;

    /// Performs `count` advances, or fewer when Γ becomes empty, and returns their number. Appends a delta for each to
    /// `deltas` unless it is null.
    virtual std::uint64_t advance(std::uint64_t count, std::vector<AdvanceDelta> *deltas = nullptr) = 0;
    /// Performs, before the first advance, all advances that threads can share. The mesh is the same, but these
    /// advances cannot be undone. Does nothing with the classic method, without the hierarchical grid, or where the
    /// mesh will be small. Returns false when cancelled or when there are more than `maxElements`; the run is then
    /// unusable.
    virtual bool advanceInParallel(unsigned threads, const Progress &progress, double estimatedElements,
                                   std::uint64_t maxElements) = 0;
    /// Undoes the last advance.
    virtual void retreat(const AdvanceDelta &delta) = 0;
    /// Returns a checkpoint of the run at its position.
    virtual Checkpoint checkpoint() const { return Checkpoint(state_); }
    /// Returns to a checkpoint of this run. `made` holds at least the nodes and elements made before it.
    virtual void restore(const Checkpoint &checkpoint, const MadeSoFar &made) = 0;
    /// Replaces the counters, after an advance that repeats an earlier one with other work.
    void setWork(const WorkCounters &work) { state_.work = work; }
    /// Returns an explanation of the next advance without changing the state. Γ must not be empty.
    virtual AdvanceExplanation explainNext() = 0;
    /// Calls visit(box, entries) for each cell of the background grid.
    virtual void forEachCell(const std::function<void(const Box2 &, std::uint32_t)> &visit) const = 0;

    /// Returns a hash of everything that the rest of the run depends on: equal for states that are equal bit for bit.
    virtual std::uint64_t stateHash() const { return state_.hash(); }
    /// Returns the mesh made so far, if it has other elements than those of the state: halves of squares, joined where
    /// both are made.
    virtual std::optional<Mesh> joinedMesh() const { return std::nullopt; }
    /// Returns the colour of each node; null: the front has no colours.
    virtual const std::vector<std::uint8_t> *colours() const { return nullptr; }

    const FrontState &state() const { return state_; }
    bool finished() const { return state_.front.empty(); }
    const DiscreteDomain &boundary() const { return *boundary_; }
    const SpacingField &spacing() const { return *spacing_; }
    /// Ends the run and moves its arrays into a mesh.
    TriMesh takeMesh() &&;
    /// Reserves memory for this many elements, so that growth copies nothing and never doubles the memory.
    void reserve(std::uint64_t elements);
    /// Number of elements to reserve memory for, per estimated element. The estimate may be a fifth too low, and memory
    /// that is never touched costs nothing.
    static constexpr double kReserve = 1.5;

  protected:
    Mesher(std::shared_ptr<const DiscreteDomain> boundary, std::shared_ptr<const SpacingField> spacing,
           const FrontCare &care, const FrontRules &rules);
    /// Restores everything but the background grid and the order of the classic method, which follow from Γ.
    void restoreState(const Checkpoint &checkpoint, const MadeSoFar &made);

    std::shared_ptr<const DiscreteDomain> boundary_;
    std::shared_ptr<const SpacingField> spacing_;
    FrontState state_;
};

/// Adds the regions, tags and names of a boundary to a mesh whose elements are those of its front. `elementFaces`: as
/// FrontState::elementFaces.
void addTags(TriMesh &mesh, const DiscreteDomain &boundary, const std::vector<std::uint32_t> &elementFaces);

/// Returns the mesh made so far with regions, tags and names. It has all nodes of the boundary, used or not.
TriMesh toMesh(const FrontState &state, const DiscreteDomain &boundary);

} // namespace forefront
