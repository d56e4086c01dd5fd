#pragma once

#include "core/engine/mesher/fan.hpp"
#include "core/engine/mesher/front_update.hpp"
#include "core/engine/quads/coloured_search.hpp"
#include "core/engine/quads/coloured_state.hpp"
#include "core/engine/quads/square_trace.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace forefront {

/// The two-coloured front: an advancing front whose triangles are halves of squares. Nodes have two colours; all edges
/// of the boundary join different ones. A triangle has two sides between different colours, its legs, and one between
/// equal colours, its diagonal. Dropping the diagonals joins triangles to quadrilaterals.
///
/// A base makes a whole square where that is simple: it continues a row at a corner of Γ of about 90 degrees, starts a
/// row on both sides of which Γ is straight, or closes a gap one square wide. Everything else goes through a search
/// like the ten steps of the classic method, with its guarantee that the front closes: new nodes keep their distance
/// from Γ, and those closer than the node spacing allows are limited in number.
template <class Grid, class Trace>
class ColouredAdvancer {
  public:
    /// Cell width of the HierarchicalGrid, in segment lengths, as of the fast method.
    static constexpr double kCellPerLength = 12.0;

    /// Refers to its arguments except the trace. `fixed`: the number of nodes of the boundary, which come first.
    ColouredAdvancer(FrontState &state, ColouredState &coloured, Grid &grid, const SpacingField &spacing, Trace trace,
                     std::size_t fixed)
        : state_(state), coloured_(coloured), spacing_(spacing), trace_(std::move(trace)),
          fans_(state, grid, spacing, trace_), update_(state, grid, &spacing),
          search_(state, grid, spacing, trace_, coloured.colours, coloured.opposite, fixed) {}
    ColouredAdvancer(const ColouredAdvancer &) = delete; // its parts share one trace
    ColouredAdvancer &operator=(const ColouredAdvancer &) = delete;

    /// Prepares the state for a new run: the node spacing at the nodes of Γ, and its bases.
    static void prepare(FrontState &state, ColouredState &coloured, const SpacingField &spacing);

    /// Makes one to two elements, or defers a base. Returns false when Γ = ∅.
    bool advance(AdvanceDelta &delta);
    /// Undoes the last advance, exactly. The log must have been kept.
    void retreat(const AdvanceDelta &delta);

  private:
    using Made = std::uint64_t ColouredWork::*;
    /// What an advance has made.
    struct Outcome {
        Made count = nullptr;
        SquareKind square = SquareKind::None;
        Vec2 apex;
    };

    bool isLegAt(SlotId id) const { return isLeg(state_.front, coloured_.colours, id); }
    bool trySquare(SlotId id, Outcome &outcome);
    bool tryRow(SlotId first, Outcome &outcome);
    bool tryOpening(SlotId id, Outcome &outcome);
    void addOpening(SlotId id, const Fan &overB, const Fan &overA);
    bool tryClosing(SlotId id, Outcome &outcome);
    AdvanceDelta closeCorner(const Fan &corner);
    void searchApex(Base &base, bool again, Outcome &outcome);
    bool isClear(Fan &fan, double size);
    bool refuse(Verdict why);
    void proposeRow(const Fan &fan, double size);
    void proposeOpening(const Fan &overB, const Fan &overA, double size);
    void addTriangle(const Base &base, Candidate apex, std::uint8_t colour, bool forced);
    void made(AdvanceDelta &delta, std::uint32_t layer, std::size_t segments);
    void finish(const Outcome &outcome, AdvanceDelta &delta);
    void setOpposite(SlotId id, NodeId node);

    FrontState &state_;
    ColouredState &coloured_;
    const SpacingField &spacing_;
    Trace trace_;
    FanBuilder<Grid, typename Trace::Fans> fans_;
    FrontUpdate<Grid> update_;
    ColouredSearch<Grid, Trace> search_;
    SearchWork work_;         ///< not yet counted
    std::uint32_t layer_ = 0; ///< of the current base
    unsigned changes_ = 0;    ///< of Γ in the current advance
    std::array<AdvanceDelta, 2> halves_;
};

} // namespace forefront
