#pragma once

#include "core/engine/mesher/apex_search.hpp"
#include "core/engine/mesher/clearance.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Tests the sides AC and CB that a candidate C gives the element over a base (step 8, exact). Returns OutsideAngle
/// unless they leave A, B and C on the unmeshed side, CrossesFront if one of them meets a segment of Γ, else Accepted.
/// A side that is already a segment of Γ needs no test. `neighbours`: all segments that can meet a side, among them AB.
template <class Trace>
Verdict testSides(const GenerationFront &front, const std::vector<NearSegment> &neighbours, const Base &base,
                  const Candidate &apex, Trace &trace, SearchWork &work) {
    const bool known = apex.slot != kNoSlot;
    const bool existsAC = known && front.prev(base.slotA) == apex.slot;
    const bool existsCB = known && front.next(base.slotB) == apex.slot;
    const auto leaves = [&](SlotId end, Vec2 at) {
        return front.insideAngle(end, apex.position) && (!known || front.insideAngle(apex.slot, at));
    };
    if ((!existsAC && !leaves(base.slotA, base.a)) || (!existsCB && !leaves(base.slotB, base.b))) {
        return Verdict::OutsideAngle;
    }
    // Segments that share an end with the side are skipped: the angle tests have dealt with them.
    const auto crosses = [&](Vec2 from, NodeId fromNode) {
        work.considered += static_cast<std::uint32_t>(neighbours.size()) - 1U; // without AB
        const Box2 box = boxOf(from, apex.position);
        for (const NearSegment &n : neighbours) {
            const bool sharesEnd =
                n.nodeA == fromNode || n.nodeB == fromNode || n.nodeA == apex.node || n.nodeB == apex.node;
            if (n.slot == base.slotA || sharesEnd || !box.overlaps(boxOf(n.a, n.b))) {
                continue;
            }
            ++work.tested;
            const bool meets = segmentsMeet(from, apex.position, n.a, n.b);
            trace.testSegment(from, apex.position, n.a, n.b, meets);
            if (meets) {
                trace.block(n.a, n.b);
                return true;
            }
        }
        return false;
    };
    const bool crossing = (!existsAC && crosses(base.a, base.nodeA)) || (!existsCB && crosses(base.b, base.nodeB));
    return crossing ? Verdict::CrossesFront : Verdict::Accepted;
}

} // namespace forefront
