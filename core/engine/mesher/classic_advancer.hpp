#pragma once

#include "core/engine/mesher/front_update.hpp"

namespace forefront {

/// The classic method: Lo's ten steps. Each advance takes the shortest base (see BaseOrder) and makes at most
/// one element. FrontRules holds what can be changed; this text tells the defaults. Lengths and scores that differ only
/// by rounding are equal: then the oldest segment goes first, and the node with the lowest number.
///
/// Closing guarantee. A base first looks for the best of the nearby front nodes and a new node. If none passes it is
/// deferred once; the second time, after a wider search, only existing nodes are taken and the search grows until it
/// covers all of Γ. Γ is a set of polygons with holes that do not cross (exact predicates), and such a set has a
/// triangulation, in which every segment has a visible apex: that last search cannot fail. By Euler's formula, each
/// element made without a new node lowers the number of elements still needed by one. New nodes keep a distance in
/// proportion to the node spacing from Γ, hence from all nodes, so only finitely many fit; those far smaller than the
/// node spacing are counted against FrontState::smallNodesLeft. None of this depends on the order of bases, the radii,
/// the score or the deferral; the clearances have a minimum.
template <class Grid, class Trace>
class ClassicAdvancer {
  public:
    /// Cell width of the HierarchicalGrid, in segment lengths. Small, since searches look at all segments of a cell and
    /// count them as Nc. Measured: no difference from 3 to 6.
    static constexpr double kCellPerLength = 3.5;

    ClassicAdvancer(FrontState &state, Grid &grid, const SpacingField &spacing, Trace trace)
        : state_(state), trace_(trace), search_(state, grid, spacing, trace_, Ties::Rounded, state.rules),
          update_(state, grid, nullptr) {}
    ClassicAdvancer(const ClassicAdvancer &) = delete; // its parts share one trace
    ClassicAdvancer &operator=(const ClassicAdvancer &) = delete;

    /// Prepares the state for a new run.
    static void prepare(FrontState &state, const DiscreteDomain &, const SpacingField &) {
        state.order.rebuild(state.front);
    }

    /// Performs steps 2 to 9 once. Returns false when Γ = ∅ (step 10).
    bool advance(AdvanceDelta &delta);
    /// Undoes the last advance, exactly.
    void retreat(const AdvanceDelta &delta);
    /// Does nothing: the order of bases follows from Γ alone and needs no log.
    void keepLog(bool) {}

  private:
    FrontState &state_;
    Trace trace_;
    ApexSearch<Grid, Trace> search_;
    FrontUpdate<Grid> update_;
};

} // namespace forefront
