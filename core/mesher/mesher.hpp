#pragma once

#include "core/base/progress.hpp"
#include "core/mesher/front_state.hpp"
#include "core/mesher/options.hpp"
#include "core/mesher/trace.hpp"
#include "core/spacing/spacing_field.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace forefront {

/// A run of the front over a discretised domain, whatever its background grid; pauses between advances. One virtual
/// call a batch.
class Mesher {
  public:
    /// The domain and the spacing are shared and must be behind the door of `validate`.
    static std::unique_ptr<Mesher> create(std::shared_ptr<const DiscreteDomain> boundary,
                                          std::shared_ptr<const SpacingField> spacing, const MeshingOptions &options);
    virtual ~Mesher() = default;

    /// Up to `count` advances; fewer only when Γ = ∅. Returns how many. Each is appended to `deltas` where given.
    virtual std::uint64_t advance(std::uint64_t count, std::vector<AdvanceDelta> *deltas = nullptr) = 0;
    /// Performs, before the first advance, as many of them as can be shared by threads: the mesh is the same, but they
    /// cannot be taken back. None with the classic method, with another grid than the hierarchical one, or where the
    /// mesh will be small. False when cancelled; the run is then of no use any
    /// more.
    virtual bool advanceTogether(unsigned threads, const Progress &progress, double estimatedElements) = 0;
    /// Takes back the advance done last.
    virtual void retreat(const AdvanceDelta &delta) = 0;
    /// The next advance with everything that happens in it; the state stays as it is. Γ must not be empty.
    virtual AdvanceExplanation explainNext() = 0;
    /// Calls visit(box, entries) for each cell of the background grid.
    virtual void forEachCell(const std::function<void(const Box2 &, std::uint32_t)> &visit) const = 0;

    const FrontState &state() const { return state_; }
    bool finished() const { return state_.front.empty(); }
    const DiscreteDomain &boundary() const { return *boundary_; }
    const SpacingField &spacing() const { return *spacing_; }
    /// Ends the run and hands out its arrays as a mesh.
    Mesh takeMesh() &&;
    /// Makes room for about as many elements: growth without copies and without their passing double memory.
    void reserve(std::uint64_t elements);
    /// Room to make for each element of an estimate, which may be a fifth too low. What is not needed is never touched
    /// and costs nothing.
    static constexpr double kRoom = 1.5;

  protected:
    Mesher(std::shared_ptr<const DiscreteDomain> boundary, std::shared_ptr<const SpacingField> spacing,
           const FrontCare &care);

    std::shared_ptr<const DiscreteDomain> boundary_;
    std::shared_ptr<const SpacingField> spacing_;
    FrontState state_;
};

/// The mesh made so far with regions, tags and names; nodes of the boundary are all in it, also those not yet reached.
Mesh toMesh(const FrontState &state, const DiscreteDomain &boundary);

} // namespace forefront
