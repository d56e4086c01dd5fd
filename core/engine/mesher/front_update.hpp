#pragma once

#include "core/engine/mesher/apex_search.hpp"

#include <span>

namespace forefront {

/// Performs and undoes step 9 of the ten: adds elements and updates Γ and the grid. Nothing else changes Γ.
template <class Grid>
class FrontUpdate {
  public:
    /// `slotSpacing`: the spacing field if the slots of the front carry the node spacing; else null.
    FrontUpdate(FrontState &state, Grid &grid, const SpacingField *slotSpacing)
        : state_(state), grid_(grid), slotSpacing_(slotSpacing) {}

    /// Returns the delta for an advance from this base, before any change.
    AdvanceDelta begin(SlotId slotA) const;
    /// Adds the element ABC.
    void addElement(const Base &base, const Candidate &apex, AdvanceDelta &delta);
    /// Adds elements with a new node over the two or three successive segments that start at the slots of `chain`.
    void addFan(std::span<const SlotId> chain, Vec2 node, double rho, AdvanceDelta &delta);
    /// Defers the base: puts it back with a higher failure class.
    void defer(SlotId slotA, AdvanceDelta &delta);
    /// Undoes the last advance, exactly.
    void undo(const AdvanceDelta &delta);
    /// Adds the advance to the work counters or, unless `forward`, subtracts it. `segments`: of Γ before the advance.
    void count(const AdvanceDelta &delta, std::size_t segments, bool forward);

    /// Calls visit(slot) for each segment that the advance added to Γ.
    template <class Visit>
    static void forEachNew(const AdvanceDelta &delta, Visit &&visit);
    /// Calls visit(slot) for each segment that undo() restored.
    template <class Visit>
    static void forEachRestored(const AdvanceDelta &delta, Visit &&visit);

  private:
    void pushElement(NodeId a, NodeId b, NodeId c, std::uint32_t face);
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
    case Kind::Opening: // done as two advances
    case Kind::Closing:
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
