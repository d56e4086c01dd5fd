#include "core/engine/mesher/front_update.hpp"

#include "core/engine/mesher/instantiate.hpp"

namespace forefront {

template <class Grid>
AdvanceDelta FrontUpdate<Grid>::begin(SlotId slotA) const {
    AdvanceDelta delta;
    delta.a = slotA;
    delta.b = state_.front.next(slotA);
    delta.markA = state_.front[slotA].mark;
    return delta;
}

template <class Grid>
void FrontUpdate<Grid>::pushElement(NodeId a, NodeId b, NodeId c, std::uint32_t face) {
    state_.elements.push_back({a, b, c});
    if (state_.manyFaces) {
        state_.elementFaces.push_back(face);
    }
}

template <class Grid>
NodeId FrontUpdate<Grid>::pushNode(Vec2 position) {
    const NodeId node{state_.firstNode + static_cast<std::uint32_t>(state_.nodes.size())};
    state_.nodes.push_back(position);
    return node;
}

template <class Grid>
void FrontUpdate<Grid>::addElement(const Base &base, const Candidate &apex, AdvanceDelta &delta) {
    GenerationFront &front = state_.front;
    const std::uint32_t face = front[base.slotA].face;
    delta.s = apex.slot;
    NodeId apexNode = apex.node;
    SlotId kept = kNoSlot; // slot whose new segment lies in the same cell as the old one
    const auto removeUnlessKept = [&](SlotId id, Vec2 a, Vec2 b) {
        if (grid_.keeps(id, a, b)) {
            kept = id;
        } else {
            remove(id);
        }
    };
    if (apex.slot == kNoSlot) {
        delta.kind = AdvanceDelta::Kind::NewNode;
        delta.smallNode = base.small();
        removeUnlessKept(base.slotA, base.a, apex.position);
        apexNode = pushNode(apex.position);
        delta.s = front.insertAfter(base.slotA, apex.position, apexNode);
        restoreRho(delta.s);
    } else if (front.prev(base.slotA) == apex.slot && front.next(base.slotB) == apex.slot) {
        delta.kind = AdvanceDelta::Kind::Loop;
        delta.markB = front[base.slotB].mark;
        delta.markS = front[apex.slot].mark;
        remove(base.slotA);
        remove(base.slotB);
        remove(apex.slot);
        front.removeLoop(base.slotA);
    } else if (front.prev(base.slotA) == apex.slot) {
        delta.kind = AdvanceDelta::Kind::Previous;
        delta.markS = front[apex.slot].mark;
        remove(base.slotA);
        removeUnlessKept(apex.slot, apex.position, base.b);
        front.cutOut(base.slotA);
    } else if (front.next(base.slotB) == apex.slot) {
        delta.kind = AdvanceDelta::Kind::Next;
        delta.markB = front[base.slotB].mark;
        removeUnlessKept(base.slotA, base.a, apex.position);
        remove(base.slotB);
        front.cutOut(base.slotB);
    } else {
        delta.kind = AdvanceDelta::Kind::Connection;
        removeUnlessKept(base.slotA, base.a, apex.position);
        if (front.isolated(apex.slot)) {
            remove(apex.slot);
        }
        delta.t = front.connect(base.slotA, apex.slot);
    }
    if (kept != kNoSlot) {
        grid_.moved(front, kept);
    }
    forEachNew(delta, [&](SlotId id) {
        if (id != kept) {
            insert(id);
        }
    });
    pushElement(base.nodeA, base.nodeB, apexNode, face);
}

template <class Grid>
void FrontUpdate<Grid>::addFan(std::span<const SlotId> chain, Vec2 position, double rho, AdvanceDelta &delta) {
    GenerationFront &front = state_.front;
    const bool three = chain.size() == 3;
    delta.kind = three ? AdvanceDelta::Kind::Three : AdvanceDelta::Kind::Two;
    delta.a = chain[0];
    delta.b = chain[1];
    delta.markA = front[delta.a].mark;
    delta.markB = front[delta.b].mark;
    const std::uint32_t face = front[delta.a].face;
    const NodeId node = pushNode(position);
    for (const SlotId id : chain) {
        pushElement(front[id].node, front[front.next(id)].node, node, face);
    }
    const bool keepA = grid_.keeps(delta.a, front.start(delta.a), position);
    const bool keepB = grid_.keeps(delta.b, position, front.end(chain.back()));
    if (!keepA) {
        remove(delta.a);
    }
    if (!keepB) {
        remove(delta.b);
    }
    if (three) {
        delta.s = chain[2];
        delta.markS = front[delta.s].mark;
        remove(delta.s);
        front.cutOut(delta.s);
    }
    front.replace(delta.b, position, node);
    front.setRho(delta.b, rho);
    if (keepA) { // before any insertion, which may split the cell
        grid_.moved(front, delta.a);
    }
    if (keepB) {
        grid_.moved(front, delta.b);
    }
    if (!keepA) {
        insert(delta.a);
    }
    if (!keepB) {
        insert(delta.b);
    }
}

template <class Grid>
void FrontUpdate<Grid>::defer(SlotId slotA, AdvanceDelta &delta) {
    delta.kind = AdvanceDelta::Kind::Deferral;
    state_.front.setFailureClass(slotA, delta.markA.failureClass + 1);
}

template <class Grid>
void FrontUpdate<Grid>::restoreRho(SlotId id) {
    if (slotSpacing_ != nullptr) {
        state_.front.setRho(id, slotSpacing_->at(state_.front.start(id)));
    }
}

template <class Grid>
void FrontUpdate<Grid>::undo(const AdvanceDelta &delta) {
    using Kind = AdvanceDelta::Kind;
    if (delta.kind == Kind::Deferral) {
        state_.front.setFailureClass(delta.a, delta.markA.failureClass);
    } else {
        forEachNew(delta, [&](SlotId id) { remove(id); });
        undoTopology(delta);
        forEachRestored(delta, [&](SlotId id) {
            restoreRho(id);
            insert(id);
        });
        const std::size_t left = state_.elements.size() - delta.elements();
        state_.elements.resize(left);
        if (state_.manyFaces) {
            state_.elementFaces.resize(left);
        }
    }
    count(delta, state_.front.segments(), false);
}

template <class Grid>
void FrontUpdate<Grid>::undoTopology(const AdvanceDelta &delta) {
    using Kind = AdvanceDelta::Kind;
    GenerationFront &front = state_.front;
    const Element &element = state_.elements[state_.elements.size() - delta.elements()]; // the first of the advance
    const auto position = [&](NodeId node) { return state_.nodes[index(node) - state_.firstNode]; };
    switch (delta.kind) {
    case Kind::Deferral:
    case Kind::Opening:
    case Kind::Closing:
        break;
    case Kind::NewNode:
        front.undoInsertAfter(delta.a, delta.s, delta.markA);
        state_.nodes.pop_back();
        break;
    case Kind::Previous:
        front.undoCutOut(delta.a, delta.s, element[0], position(element[0]), delta.markA, delta.markS);
        break;
    case Kind::Next:
        front.undoCutOut(delta.b, delta.a, element[1], position(element[1]), delta.markB, delta.markA);
        break;
    case Kind::Loop:
        front.undoRemoveLoop({{delta.a, element[0], position(element[0]), delta.markA},
                              {delta.b, element[1], position(element[1]), delta.markB},
                              {delta.s, element[2], position(element[2]), delta.markS}},
                             state_.manyFaces ? state_.elementFaces.back() : 0);
        break;
    case Kind::Connection:
        front.undoConnect(delta.a, delta.s, delta.t, delta.markA);
        if (delta.s == delta.t) {
            insert(delta.s);
        }
        break;
    case Kind::Two:
    case Kind::Three:
        front.undoReplace(delta.b, element[1], position(element[1]), delta.markB, delta.markA);
        if (delta.kind == Kind::Three) {
            const NodeId last = state_.elements.back()[0];
            front.undoCutOut(delta.s, delta.b, last, position(last), delta.markS, delta.markB);
        }
        state_.nodes.pop_back();
        break;
    }
}

template <class Grid>
void FrontUpdate<Grid>::count(const AdvanceDelta &delta, std::size_t segments, bool forward) {
    using Kind = AdvanceDelta::Kind;
    WorkCounters &work = state_.work;
    const auto add = [forward](std::uint64_t &sum, std::uint64_t value) { sum = forward ? sum + value : sum - value; };
    add(work.advances, 1);
    add(work.elements, delta.elements());
    add(work.deferrals, delta.kind == Kind::Deferral);
    add(work.newNodes, delta.kind == Kind::NewNode || delta.kind == Kind::Two || delta.kind == Kind::Three);
    add(work.forced, delta.forced);
    add(work.frontSum, segments);
    add(work.delivered, delta.delivered);
    add(work.considered, delta.considered);
    add(work.tested, delta.tested);
    add(work.cellsVisited, delta.cells);
    add(work.candidates, delta.candidates);
    if (delta.smallNode) {
        forward ? --state_.smallNodesLeft : ++state_.smallNodesLeft;
    }
}

FOREFRONT_INSTANTIATE_FOR_GRIDS(FrontUpdate)

} // namespace forefront
