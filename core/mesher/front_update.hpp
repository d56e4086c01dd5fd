#pragma once

#include "core/mesher/apex_search.hpp"

#include <span>

namespace forefront {

/// Step 9 of the ten and its reverse: the elements, Γ and the grid, whatever the order of bases. Γ only ever changes
/// here.
template <class Grid>
class FrontUpdate {
  public:
    /// `slotSpacing`: where the slots carry the node spacing, its field; else null.
    FrontUpdate(FrontState &state, Grid &grid, const SpacingField *slotSpacing)
        : state_(state), grid_(grid), slotSpacing_(slotSpacing) {}

    /// A delta for an advance from this base.
    AdvanceDelta begin(SlotId slotA) const;
    /// The element ABC.
    void addElement(const Base &base, const Candidate &apex, AdvanceDelta &delta);
    /// Elements over the segments that start at the slots of `chain` (two or three, successive), with a new node.
    void addFan(std::span<const SlotId> chain, Vec2 node, double rho, AdvanceDelta &delta);
    /// The base is put back with a higher failure class.
    void defer(SlotId slotA, AdvanceDelta &delta);
    /// Takes back the advance done last, exactly.
    void undo(const AdvanceDelta &delta);
    /// Adds the advance to the work counters, or takes it off. `segments`: of Γ before the advance.
    void count(const AdvanceDelta &delta, std::size_t segments, bool forward);

    /// Calls visit(slot) for each segment that the advance has put into Γ.
    template <class Visit>
    static void forEachNew(const AdvanceDelta &delta, Visit &&visit);
    /// Calls visit(slot) for each segment that undo() has put back.
    template <class Visit>
    static void forEachRestored(const AdvanceDelta &delta, Visit &&visit);

  private:
    void pushElement(NodeId a, NodeId b, NodeId c, std::uint32_t region);
    NodeId pushNode(Vec2 position);
    void undoTopology(const AdvanceDelta &delta);
    void insert(SlotId id) { grid_.insert(state_.front, id); }
    void remove(SlotId id) { grid_.remove(state_.front, id); }
    void restoreRho(SlotId id);

    FrontState &state_;
    Grid &grid_;
    const SpacingField *slotSpacing_;
};

template <class Grid>
template <class Visit>
void FrontUpdate<Grid>::forEachNew(const AdvanceDelta &delta, Visit &&visit) {
    using Kind = AdvanceDelta::Kind;
    switch (delta.kind) {
    case Kind::Deferral:
    case Kind::Next:
        visit(delta.a);
        break;
    case Kind::NewNode:
        visit(delta.a);
        visit(delta.s);
        break;
    case Kind::Previous:
        visit(delta.s);
        break;
    case Kind::Connection:
        visit(delta.a);
        visit(delta.t);
        break;
    case Kind::Two:
    case Kind::Three:
        visit(delta.a);
        visit(delta.b);
        break;
    case Kind::Loop:
        break;
    }
}

template <class Grid>
template <class Visit>
void FrontUpdate<Grid>::forEachRestored(const AdvanceDelta &delta, Visit &&visit) {
    using Kind = AdvanceDelta::Kind;
    visit(delta.a);
    if (delta.kind == Kind::Next || delta.kind == Kind::Loop || delta.kind == Kind::Two || delta.kind == Kind::Three) {
        visit(delta.b);
    }
    if (delta.kind == Kind::Previous || delta.kind == Kind::Loop || delta.kind == Kind::Three) {
        visit(delta.s);
    }
}

} // namespace forefront
