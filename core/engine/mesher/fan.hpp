#pragma once

#include "core/engine/mesher/apex_search.hpp"

#include <array>
#include <span>

namespace forefront {

/// Elements proposed over one to three successive segments X0X1, X1X2, ... of Γ with a common apex C, a new node. A fan
/// can also represent a corner X0X1X2 that the segment X0X2 closes without a new node.
struct Fan {
    static constexpr unsigned kMaxSegments = 3;

    unsigned segments = 0;
    std::array<SlotId, kMaxSegments + 1> slots{};
    std::array<Vec2, kMaxSegments + 1> at{};
    std::array<NodeId, kMaxSegments + 1> nodes{};
    Vec2 apex;
    double size = 0.0; ///< element size that the apex was placed with
    double rho = 0.0;  ///< node spacing at `rhoThere`
    Vec2 rhoThere;     ///< the apex before its last correction, or the apex

    /// The fan over `segments` segments from slot `first` on, without its apex.
    Fan(const GenerationFront &front, SlotId first, unsigned segments);
    std::span<const SlotId> chain() const { return {slots.data(), segments}; }
    SlotId last() const { return slots[segments]; }
    Box2 box() const;
};

/// Places and tests fans. The answers are exact and depend on Γ alone, never on the grid.
template <class Grid, class Trace>
class FanBuilder {
  public:
    FanBuilder(const FrontState &state, const Grid &grid, const SpacingField &spacing, Trace &trace)
        : state_(state), grid_(grid), spacing_(spacing), trace_(trace) {}

    /// Places the apex at the mean of the ideal points of the segments. Returns false where that would make badly
    /// shaped elements, or elements too small for the node spacing.
    bool place(Fan &fan) const;
    /// Returns a box that meets everything that clear() depends on.
    static Box2 reach(const Fan &fan);
    /// Returns true if the elements lie on the unmeshed side, meet no segment and enclose no node of Γ, no new side
    /// comes within rounding of one, and the apex keeps its distance from both (as in step 7).
    bool clear(const Fan &fan, const Box2 &reach, SearchWork &work);
    /// Returns true if the element X0X1X2 of a corner lies on the unmeshed side, is not flat, and neither it nor its
    /// new third side meets anything of Γ, within rounding for nodes.
    bool cornerClear(const Fan &corner, SearchWork &work);

  private:
    bool anglesAllow(const Fan &fan) const;
    struct Boxes {
        Box2 reach, fan, firstSide, lastSide; ///< of the fan, with a margin for rounding
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
