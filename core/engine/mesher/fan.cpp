#include "core/engine/mesher/fan.hpp"

#include "core/engine/geometry/flat.hpp"
#include "core/engine/mesher/clearance.hpp"
#include "core/engine/mesher/instantiate.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

namespace {

// Maximum distance of the apex from the nodes of its chain and minimum distance from other nodes of Γ, in element
// sizes.
constexpr double kMaxDistance = 1.3;
constexpr double kFanClearance = 0.8;
// Minimum distance of the apex from segments of Γ, in element sizes.
constexpr double kSideClearance = FrontRules{}.segmentClearance;

Vec2 idealPoint(Vec2 a, Vec2 b, double length, double size) {
    const double rho = clampedToBase(size, length);
    const double height =
        std::sqrt(std::max(rho * rho - 0.25 * length * length, kMinHeight * kMinHeight * length * length));
    return midpoint(a, b) + (height / length) * leftNormal(b - a);
}

} // namespace

Fan::Fan(const GenerationFront &front, SlotId first, unsigned count) : segments(count) {
    SlotId id = first;
    for (unsigned i = 0; i <= count; ++i) {
        const FrontSlot &slot = front[id];
        slots[i] = id;
        at[i] = slot.position;
        nodes[i] = slot.node;
        id = slot.next;
    }
}

Box2 Fan::box() const {
    Box2 box = boxOf(at[0], at[1]);
    for (unsigned i = 2; i <= segments; ++i) {
        box.add(at[i]);
    }
    return box;
}

template <class Grid, class Trace>
bool FanBuilder<Grid, Trace>::place(Fan &fan) const {
    const GenerationFront &front = state_.front;
    std::array<double, Fan::kMaxSegments> lengths{}, sizes{};
    for (unsigned i = 0; i < fan.segments; ++i) {
        lengths[i] = front[fan.slots[i]].length;
        sizes[i] = 0.5 * (front[fan.slots[i]].rho + front[fan.slots[i + 1]].rho);
    }
    const double share = 1.0 / fan.segments;
    const auto meanOfIdeals = [&](double pull) { // `pull`: added to the spacing of the segments
        Vec2 sum;
        for (unsigned i = 0; i < fan.segments; ++i) {
            sum += idealPoint(fan.at[i], fan.at[i + 1], lengths[i], sizes[i] + pull);
        }
        return share * sum;
    };
    fan.size = 0.0;
    for (unsigned i = 0; i < fan.segments; ++i) {
        fan.size += share * clampedToBase(sizes[i], lengths[i]);
    }
    double mean = 0.0;
    for (unsigned i = 0; i < fan.segments; ++i) {
        mean += share * sizes[i];
    }
    fan.apex = meanOfIdeals(0.0);
    fan.rho = spacing_.at(fan.apex);
    fan.rhoThere = fan.apex;
    if (fan.rho != mean) { // the elements lead from the spacing at the segments to that at the apex
        fan.apex = meanOfIdeals(0.5 * (fan.rho - mean));
        fan.size = clampedToBase(0.5 * (fan.rho + mean), fan.size);
    }
    if (fan.size < kSmallNode * fan.rho) {
        return false;
    }
    const double min2 = state_.care.minDistance * state_.care.minDistance * fan.size * fan.size;
    const double max2 = kMaxDistance * kMaxDistance * fan.size * fan.size;
    for (unsigned i = 0; i <= fan.segments; ++i) {
        const double d = distanceSquared(fan.apex, fan.at[i]);
        if (d < min2 || d > max2) {
            return false;
        }
    }
    for (unsigned i = 0; i < fan.segments; ++i) {
        if (isFlat(fan.at[i], fan.at[i + 1], fan.apex, kAvoidedFlatness)) {
            return false;
        }
    }
    return true;
}

template <class Grid, class Trace>
Box2 FanBuilder<Grid, Trace>::reach(const Fan &fan) {
    Box2 box = boxAround(fan.apex, kFanClearance * fan.size);
    box.add(fan.box());
    return box;
}

template <class Grid, class Trace>
bool FanBuilder<Grid, Trace>::anglesAllow(const Fan &fan) const {
    const GenerationFront &front = state_.front;
    return front.insideAngle(fan.slots[0], fan.apex) && front.insideAngle(fan.last(), fan.apex);
}

template <class Grid, class Trace>
void FanBuilder<Grid, Trace>::visited(const Box2 &cell, SearchWork &work) {
    ++work.cells;
    trace_.visitCell(cell);
}

template <class Grid, class Trace>
bool FanBuilder<Grid, Trace>::clear(const Fan &fan, const Box2 &reach, SearchWork &work) {
    if (!anglesAllow(fan)) {
        return false;
    }
    const GenerationFront &front = state_.front;
    Boxes boxes{reach, fan.box(), boxOf(fan.at[0], fan.apex), boxOf(fan.at[fan.segments], fan.apex)};
    boxes.fan.add(fan.apex);
    boxes.fan = boxes.fan.grown(roundingMargin(boxes.fan));
    constexpr unsigned kMaxNear = 32;
    std::array<SlotId, kMaxNear> near;
    unsigned count = 0;
    bool free = true;
    const auto look = [&] {
        for (unsigned k = 0; k < count && free; ++k) {
            free = !blocks(fan, boxes, front[near[k]], work);
        }
        count = 0;
    };
    const SlotId second = fan.segments > 1 ? fan.slots[1] : fan.slots[0];
    const SlotId third = fan.segments > 2 ? fan.slots[2] : fan.slots[0];
    const std::uint32_t delivered = grid_.queryNear(
        front, reach,
        [&](SlotId id) { // skips the chain without a branch, which could not be predicted
            near[count] = id;
            count += static_cast<unsigned>((id != fan.slots[0]) & (id != second) & (id != third));
            if (count == kMaxNear) {
                look();
            }
        },
        [&](const Box2 &cell) { visited(cell, work); });
    look();
    work.delivered += delivered;
    trace_.deliver(delivered);
    return free;
}

template <class Grid, class Trace>
bool FanBuilder<Grid, Trace>::blocks(const Fan &fan, const Boxes &boxes, const FrontSlot &n, SearchWork &work) {
    const Vec2 a = n.position;
    const Vec2 b = state_.front.start(n.next);
    const Box2 box = boxOf(a, b);
    if (!boxes.reach.overlaps(box)) { // exactly the same for every grid
        return false;
    }
    work.considered += 2; // for each of the two outer sides
    const double size2 = fan.size * fan.size;
    if (nearSegment(fan.apex, a, b, kSideClearance * kSideClearance * size2)) {
        return true;
    }
    const auto end = fan.nodes.begin() + fan.segments + 1;
    if (std::find(fan.nodes.begin(), end, n.node) == end) { // not a node of the chain
        if (distanceSquared(fan.apex, a) < kFanClearance * kFanClearance * size2) {
            return true;
        }
        if (boxes.fan.contains(a)) {
            for (unsigned i = 0; i < fan.segments; ++i) {
                if (insideOrOn(fan.at[i], fan.at[i + 1], fan.apex, a)) {
                    return true;
                }
            }
            if (nearlyOnSegment(fan.at[0], fan.apex, a) || nearlyOnSegment(fan.at[fan.segments], fan.apex, a)) {
                return true; // the element left there would be flat
            }
        }
    }
    const unsigned last = fan.segments;
    return (box.overlaps(boxes.firstSide) && meets(fan.at[0], fan.nodes[0], fan.apex, kNoNode, n, work)) ||
           (box.overlaps(boxes.lastSide) && meets(fan.at[last], fan.nodes[last], fan.apex, kNoNode, n, work));
}

/// Tests a new segment against the front segment n, whose box overlaps. Segments that share an end are skipped: the
/// angle tests have dealt with them.
template <class Grid, class Trace>
bool FanBuilder<Grid, Trace>::meets(Vec2 from, NodeId fromNode, Vec2 to, NodeId toNode, const FrontSlot &n,
                                    SearchWork &work) {
    const FrontSlot &end = state_.front[n.next];
    if (n.node == fromNode || end.node == fromNode || n.node == toNode || end.node == toNode) {
        return false;
    }
    ++work.tested;
    const bool met = segmentsMeet(from, to, n.position, end.position);
    trace_.testSegment(from, to, n.position, end.position, met);
    return met;
}

template <class Grid, class Trace>
bool FanBuilder<Grid, Trace>::cornerClear(const Fan &corner, SearchWork &work) {
    const GenerationFront &front = state_.front;
    if (isFlat(corner.at[0], corner.at[1], corner.at[2], kAvoidedFlatness) ||
        !front.insideAngle(corner.slots[0], corner.at[2]) || !front.insideAngle(corner.slots[2], corner.at[0])) {
        return false;
    }
    const Box2 box = corner.box().grown(roundingMargin(corner.box()));
    bool free = true;
    const std::uint32_t delivered = grid_.queryNear(
        front, box,
        [&](SlotId id) {
            if (free && id != corner.slots[0] && id != corner.slots[1]) {
                free = !blocksCorner(corner, box, front[id], work);
            }
        },
        [&](const Box2 &cell) { visited(cell, work); });
    work.delivered += delivered;
    trace_.deliver(delivered);
    return free;
}

template <class Grid, class Trace>
bool FanBuilder<Grid, Trace>::blocksCorner(const Fan &corner, const Box2 &box, const FrontSlot &n, SearchWork &work) {
    const auto end = corner.nodes.begin() + 3;
    if (box.contains(n.position) && std::find(corner.nodes.begin(), end, n.node) == end &&
        (insideOrOn(corner.at[0], corner.at[1], corner.at[2], n.position) ||
         nearlyOnSegment(corner.at[0], corner.at[2], n.position))) { // else the element left there would be flat
        return true;
    }
    if (!boxOf(corner.at[0], corner.at[2]).overlaps(boxOf(n.position, state_.front.start(n.next)))) {
        return false;
    }
    ++work.considered;
    return meets(corner.at[0], corner.nodes[0], corner.at[2], corner.nodes[2], n, work);
}

FOREFRONT_INSTANTIATE_FOR_GRIDS_AND_TRACES(FanBuilder)

} // namespace forefront
