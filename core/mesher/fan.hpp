#pragma once

#include "core/mesher/apex_search.hpp"

#include <array>
#include <span>

namespace forefront {

/// Elements proposed over one, two or three successive segments X0X1, X1X2, ... of Γ with one common apex C: a new
/// node, or, for one corner X0X1X2 that is closed by the segment X0X2, none.
struct Fan {
    static constexpr unsigned kMost = 3;

    unsigned segments = 0;
    std::array<SlotId, kMost + 1> slots{};
    std::array<Vec2, kMost + 1> at{};
    std::array<NodeId, kMost + 1> nodes{};
    Vec2 apex;
    double size = 0.0; ///< element size that the apex was placed with
    double rho = 0.0;  ///< node spacing at `rhoThere`: the apex or, before its last correction, near it
    Vec2 rhoThere;

    /// The `segments` segments from slot `first` on.
    Fan(const GenerationFront &front, SlotId first, unsigned segments);
    std::span<const SlotId> chain() const { return {slots.data(), segments}; }
    SlotId last() const { return slots[segments]; }
    Box2 box() const;
};

/// Places and tests fans: exact answers that depend on Γ alone, never on the grid.
template <class Grid, class Trace>
class FanBuilder {
  public:
    FanBuilder(const FrontState &state, const Grid &grid, const SpacingField &spacing, Trace &trace)
        : state_(state), grid_(grid), spacing_(spacing), trace_(trace) {}

    /// The apex: mean of the ideal points of the segments. False where it would make elements of bad shape or, against
    /// the node spacing, small ones.
    bool place(Fan &fan) const;
    /// All that bears on clear() meets this box.
    static Box2 reach(const Fan &fan);
    /// True if the elements keep to the unmeshed side, meet no segment and enclose no node of Γ, and the apex keeps its
    /// distance from both (as in step 7).
    bool clear(const Fan &fan, const Box2 &reach, SearchWork &work);
    /// The same for the element X0X1X2 of a corner, whose third side is to be new.
    bool cornerClear(const Fan &corner, SearchWork &work);

  private:
    bool anglesAllow(const Fan &fan) const;
    struct Boxes {
        Box2 reach, fan, firstSide, lastSide;
    };
    bool blocks(const Fan &fan, const Boxes &boxes, const FrontSlot &n, SearchWork &work);
    bool blocksCorner(const Fan &corner, const Box2 &box, const FrontSlot &n, SearchWork &work);
    bool meets(Vec2 from, NodeId fromNode, Vec2 to, NodeId toNode, const FrontSlot &n, SearchWork &work);
    void visited(const Box2 &cell, SearchWork &work);

    const FrontState &state_;
    const Grid &grid_;
    const SpacingField &spacing_;
    Trace &trace_;
};

} // namespace forefront
