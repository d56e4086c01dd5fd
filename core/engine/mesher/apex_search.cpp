#include "core/engine/mesher/apex_search.hpp"

#include "core/engine/geometry/flat.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesher/clearance.hpp"
#include "core/engine/mesher/instantiate.hpp"
#include "core/engine/mesher/side_tests.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace forefront {

Base baseAt(const GenerationFront &front, SlotId slotA) {
    const SlotId slotB = front.next(slotA);
    return {slotA,
            slotB,
            front.start(slotA),
            front.start(slotB),
            front[slotA].node,
            front[slotB].node,
            front[slotA].length,
            0.0,
            0.0,
            {}};
}

template <class Grid, class Trace>
void ApexSearch<Grid, Trace>::evaluateSpacing(Base &base) {
    const Vec2 middle = midpoint(base.a, base.b);
    const Vec2 normal = (1.0 / base.length) * leftNormal(base.b - base.a);
    const auto idealFor = [&](double rho) {
        const double height = std::sqrt(std::max(0.0, rho * rho - 0.25 * base.length * base.length));
        return middle + std::max(height, rules_.minHeight * base.length) * normal;
    };
    const double atMiddle = spacing_.at(middle);
    base.fieldRho = atMiddle;
    if (rules_.rhoAtC > 0.0) {
        const double atIdeal = spacing_.at(idealFor(clampedToBase(atMiddle, base.length, rules_)));
        base.fieldRho = (1.0 - rules_.rhoAtC) * atMiddle + rules_.rhoAtC * atIdeal;
    }
    base.rho = clampedToBase(base.fieldRho, base.length, rules_);
    base.ideal = idealFor(base.rho);
    trace_.evaluateSpacing(base);
}

template <class Grid, class Trace>
Box2 ApexSearch<Grid, Trace>::reach(const Base &base, double radius) {
    Box2 box = boxAround(base.ideal, radius);
    box.add(base.a);
    box.add(base.b);
    return box;
}

template <class Grid, class Trace>
void ApexSearch<Grid, Trace>::force(const Base &base, double radius, Candidate &apex) {
    constexpr std::size_t kMaxSeen = 4096; // bounds the cost of bases that have no other choice
    const GenerationFront &front = state_.front;
    bool flat = front.prev(base.slotA) == front.next(base.slotB); // the last element of a loop
    do { // ends at the latest when the search covers all of Γ, see ClassicAdvancer
        radius *= 2.0;
        FOREFRONT_ASSERT(std::isfinite(radius));
        trace_.widen();
        flat = flat || neighbours_.size() > kMaxSeen || seenAll(base);
    } while (!find(base, {radius, false, flat}, apex));
}

/// Returns true if the last search looked at all nodes of Γ.
template <class Grid, class Trace>
bool ApexSearch<Grid, Trace>::seenAll(const Base &base) const {
    const auto ofBase = std::count_if(neighbours_.begin(), neighbours_.end(), [&](const Neighbour &n) {
        return n.nodeA == base.nodeA || n.nodeA == base.nodeB;
    });
    const auto others = std::count_if(candidates_.begin(), candidates_.end(),
                                      [](const Candidate &candidate) { return candidate.slot != kNoSlot; });
    return static_cast<std::size_t>(ofBase + others) == state_.front.slots();
}

template <class Grid, class Trace>
bool ApexSearch<Grid, Trace>::find(const Base &base, const Limits &limits, Candidate &apex) {
    const double clearance = limits.newNodes ? std::max(nodeClearance_, segmentClearance_) * base.rho : 0.0;
    const double radius = std::max(limits.radius, clearance);
    gather(reach(base, radius * (1.0 + slack_)));
    rank(base, limits);
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
        trace_.beginTest(i);
        const Verdict verdict = test(base, candidates_[i], limits.flat);
        trace_.endTest(verdict);
        if (verdict == Verdict::Accepted) {
            apex = candidates_[i];
            return true;
        }
        // Where Γ passes through a node several times, the node is rejected if all passes are.
        const bool otherPass = i + 1 < candidates_.size() && candidates_[i].node != kNoNode &&
                               candidates_[i + 1].node == candidates_[i].node;
        work_.rejected += otherPass ? 0 : 1;
    }
    return false;
}

/// Collects the segments of Γ near the box, each once, in the order of their slots. The result is the same for every
/// grid.
template <class Grid, class Trace>
void ApexSearch<Grid, Trace>::gather(const Box2 &box) {
    const GenerationFront &front = state_.front;
    if (stamps_.size() < front.capacity()) {
        stamps_.resize(front.capacity() + front.capacity() / 2, 0);
    }
    if (++stamp_ == 0) {
        std::fill(stamps_.begin(), stamps_.end(), 0U);
        stamp_ = 1;
    }
    found_.clear();
    grid_.query(
        front, box,
        [&](SlotId id, bool near) {
            std::uint32_t &stamp = stamps_[index(id)];
            if (stamp != stamp_) {
                stamp = stamp_;
                ++work_.delivered;
                trace_.deliver(1);
                if (near && segmentNearBox(front.start(id), front.end(id), box)) {
                    found_.push_back(id);
                }
            }
        },
        [&](const Box2 &cell) {
            ++work_.cells;
            trace_.visitCell(cell);
        });
    std::sort(found_.begin(), found_.end());
    neighbours_.clear();
    for (const SlotId id : found_) {
        const FrontSlot &slot = front[id];
        const FrontSlot &end = front[slot.next];
        neighbours_.push_back({id, slot.node, end.node, slot.position, end.position});
    }
}

/// Collects the front nodes within the radius, and the ideal point unless it is too near to Γ; best score first, ties
/// by id (steps 5 to 7). A node at the radius is within it.
template <class Grid, class Trace>
void ApexSearch<Grid, Trace>::rank(const Base &base, const Limits &limits) {
    candidates_.clear();
    const double radius2 = (1.0 + slack_) * limits.radius * limits.radius;
    for (const Neighbour &n : neighbours_) {
        if (n.nodeA != base.nodeA && n.nodeA != base.nodeB && distanceSquared(n.a, base.ideal) <= radius2) {
            candidates_.push_back({score(base, n.a), n.a, n.nodeA, n.slot});
        }
    }
    work_.candidates += static_cast<std::uint32_t>(candidates_.size());
    bool withdrawn = false;
    if (limits.newNodes) {
        withdrawn = !idealIsClear(base) || (state_.smallNodesLeft == 0 && base.small());
        if (!withdrawn) {
            candidates_.push_back({score(base, base.ideal), base.ideal, kNoNode, kNoSlot});
            ++work_.candidates;
        }
    }
    std::sort(candidates_.begin(), candidates_.end(), [this](const Candidate &p, const Candidate &q) {
        const std::int64_t keyP = orderKey(p.score, droppedBits_), keyQ = orderKey(q.score, droppedBits_);
        if (keyP != keyQ) {
            return keyP > keyQ;
        }
        return p.node != q.node ? p.node < q.node : p.slot < q.slot;
    });
    trace_.rank(base, candidates_, limits.radius, withdrawn);
    if constexpr (!std::is_same_v<Trace, NoTrace>) {
        if (withdrawn) {
            traceBlockOfIdeal(base);
        }
    }
}

/// Records what is nearest to the ideal point in relation to its clearance, if that is too near.
template <class Grid, class Trace>
void ApexSearch<Grid, Trace>::traceBlockOfIdeal(const Base &base) {
    double least = 1.0 - slack_;
    Vec2 a, b;
    double clearance = 0.0;
    const auto offer = [&](Vec2 from, Vec2 to, double distance, double minimum) {
        if (distance < least * minimum) {
            least = distance / minimum;
            a = from;
            b = to;
            clearance = minimum;
        }
    };
    for (const Neighbour &n : neighbours_) {
        if (n.slot == base.slotA) {
            continue;
        }
        if (n.nodeA != base.nodeA && n.nodeA != base.nodeB) {
            offer(n.a, n.a, distance(n.a, base.ideal), nodeClearance_ * base.rho);
        }
        offer(n.a, n.b, distanceToSegment(n.a, n.b, base.ideal), segmentClearance_ * base.rho);
    }
    if (clearance > 0.0) {
        trace_.blockIdeal(a, b, least * clearance, clearance);
    }
}

/// Returns true if the ideal point keeps its distance from Γ. Just the minimum distance is enough: beside a square
/// corner, half a segment away from the other side, that is the rule.
template <class Grid, class Trace>
bool ApexSearch<Grid, Trace>::idealIsClear(const Base &base) const {
    const double rho2 = (1.0 - slack_) * base.rho * base.rho;
    const double node2 = nodeClearance_ * nodeClearance_ * rho2;
    const double segment2 = segmentClearance_ * segmentClearance_ * rho2;
    return std::none_of(neighbours_.begin(), neighbours_.end(), [&](const Neighbour &n) {
        if (n.slot == base.slotA) {
            return false;
        }
        const bool own = n.nodeA == base.nodeA || n.nodeA == base.nodeB;
        return (!own && distanceSquared(n.a, base.ideal) < node2) || nearSegment(base.ideal, n.a, n.b, segment2);
    });
}

template <class Grid, class Trace>
double ApexSearch<Grid, Trace>::score(const Base &base, Vec2 p) const {
    return rules_.score(shapeFactor(base.a, base.b, p), spacingConformity(distance(base.a, p), base.rho),
                        spacingConformity(distance(base.b, p), base.rho));
}

/// Tests a candidate (step 8). All tests are exact; unless `flat`, the area must be positive and nodes of Γ outside the
/// element by more than rounding can explain.
template <class Grid, class Trace>
Verdict ApexSearch<Grid, Trace>::test(const Base &base, const Candidate &candidate, bool flat) {
    if (flat ? orientation(base.a, base.b, candidate.position) <= 0
             : isFlat(base.a, base.b, candidate.position, kAvoidedFlatness) ||
                   shapeFactor(base.a, base.b, candidate.position) < slack_) {
        return Verdict::NotLeft;
    }
    const Verdict sides = testSides(state_.front, neighbours_, base, candidate, trace_, work_);
    if (sides != Verdict::Accepted) {
        return sides;
    }
    return containsNode(base, candidate, flat) ? Verdict::ContainsNode : Verdict::Accepted;
}

/// Returns true if p lies on the segment ab within rounding, or within its slack. Nodes that are on a line by
/// construction miss it by the errors of all nodes that they were built on.
template <class Grid, class Trace>
bool ApexSearch<Grid, Trace>::beside(Vec2 a, Vec2 b, Vec2 p) const {
    return nearlyOnSegment(a, b, p) || (slack_ > 0.0 && nearSegment(p, a, b, slack_ * slack_ * distanceSquared(a, b)));
}

/// Returns true if a node of Γ lies in or on the element; unless `flat`, also if it lies beside a side but so close
/// that the element left there would be flat.
template <class Grid, class Trace>
bool ApexSearch<Grid, Trace>::containsNode(const Base &base, const Candidate &candidate, bool flat) {
    Box2 box = boxOf(base.a, base.b);
    box.add(candidate.position);
    box = box.grown(roundingMargin(box) + slack_ * (box.size().x + box.size().y));
    const Vec2 c = candidate.position;
    for (const Neighbour &n : neighbours_) {
        if (n.nodeA == base.nodeA || n.nodeA == base.nodeB || n.nodeA == candidate.node || !box.contains(n.a)) {
            continue;
        }
        if (insideOrOn(base.a, base.b, c, n.a) || (!flat && (beside(base.a, c, n.a) || beside(base.b, c, n.a)))) {
            trace_.block(n.a, n.a);
            return true;
        }
    }
    return false;
}

FOREFRONT_INSTANTIATE_FOR_GRIDS_AND_TRACES(ApexSearch)

} // namespace forefront
