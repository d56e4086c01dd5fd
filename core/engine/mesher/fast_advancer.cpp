#include "core/engine/mesher/fast_advancer.hpp"

#include "core/engine/base/key_order.hpp"
#include "core/engine/mesher/classic_advancer.hpp"
#include "core/engine/mesher/instantiate.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace forefront {

namespace {

// Cosines of angles of the front. These and the lengths below were measured together on discs, a ring of small spacing
// and a coast, for the highest α and δ after improvement.
constexpr double kSharp = 0.05; ///< 87 degrees: sharper corners are closed
/// Corners are closed by a segment of at most this many node spacings. A longer one makes the next corner as sharp:
/// from the mouth of a bay on, the corners would be closed one after the other, across all of it.
constexpr double kMaxClosing = 2.0;
constexpr double kWide = -0.94;     ///< 160 degrees: segments at wider corners do not share a node
constexpr double kRoomy = -0.5;     ///< 120 degrees: wider corners have room for two nodes
constexpr double kThreeFrom = -0.8; ///< 143 degrees: three segments share a node where both corners are sharper
/// Three segments shorter than this fraction of the node spacing share a node, so that one fewer segment remains.
constexpr double kShort = 0.85;
/// Segments longer than this fraction of the node spacing get one node each, so that one more segment remains.
constexpr double kLong = 1.2;
/// Segments that share a node differ in length by less than this factor.
constexpr double kSimilar = 2.0;

bool isSegmentIn(const GenerationFront &front, SlotId id, const Box2 &box) {
    return front[id].alive && !front.isolated(id) && box.containsHalfOpen(front.start(id)) &&
           box.containsHalfOpen(front.end(id));
}

/// Offers segments, sorted by their nodes so that slots do not matter.
void offerSorted(WalkOrder &order, const GenerationFront &front, std::span<const SlotId> slots) {
    std::vector<std::uint64_t> nodes;
    nodes.reserve(slots.size());
    for (const SlotId id : slots) {
        nodes.push_back(pairKey(front[id].node, front[front.next(id)].node));
    }
    for (const std::uint32_t i : orderByKeys(nodes)) {
        order.offer(front, slots[i]);
    }
}

/// Returns true if the segment that would close a corner suits the node spacing at its ends.
bool suitsSpacing(const GenerationFront &front, const Fan &corner) {
    const double rho = 0.5 * (front[corner.slots[0]].rho + front[corner.last()].rho);
    return distanceSquared(corner.at[0], corner.at[2]) <= kMaxClosing * kMaxClosing * rho * rho;
}

/// Returns the segments of Γ inside the strips of a phase, by strip.
std::vector<std::vector<SlotId>> segmentsByStrip(const GenerationFront &front, const FrontStrips &strips,
                                                 std::size_t phase) {
    const std::size_t first = strips.phases[phase];
    std::vector<std::vector<SlotId>> lists(strips.phases[phase + 1] - first);
    for (std::uint32_t i = 0; i < front.capacity(); ++i) {
        const SlotId id{i};
        const std::size_t strip = strips.stripAt(phase, front.start(id));
        if (isSegmentIn(front, id, strips.boxes[strip])) {
            lists[strip - first].push_back(id);
        }
    }
    return lists;
}

} // namespace

void offerAll(WalkOrder &order, const GenerationFront &front, const Box2 &box) {
    std::vector<SlotId> slots;
    for (std::uint32_t i = 0; i < front.capacity(); ++i) {
        if (isSegmentIn(front, SlotId{i}, box)) {
            slots.push_back(SlotId{i});
        }
    }
    offerSorted(order, front, slots);
}

template <class Grid, class Trace>
void FastAdvancer<Grid, Trace>::prepare(FrontState &state, const DiscreteDomain &boundary, const SpacingField &spacing,
                                        double perStrip) {
    state.strips = std::make_shared<const FrontStrips>(boundary, spacing, perStrip);
    GenerationFront &front = state.front;
    for (std::uint32_t i = 0; i < front.capacity(); ++i) {
        front.setRho(SlotId{i}, spacing.at(front.start(SlotId{i})));
    }
    state.stripEnd = static_cast<std::uint32_t>(state.strips->boxes.size());
    state.walkOrder.clear(state.walkRules);
    offerAll(state.walkOrder, front, state.strips->boxes.front());
}

/// Returns the box that advances must stay in; null in the last strip.
template <class Grid, class Trace>
const Box2 *FastAdvancer<Grid, Trace>::limits() const {
    return state_.strips->last(state_.strip) ? nullptr : &state_.strips->boxes[state_.strip];
}

/// Returns the base that continues the walk, else the next of the order, else the first of the next strip.
template <class Grid, class Trace>
SlotId FastAdvancer<Grid, Trace>::nextBase() {
    if (state_.walk.base != kNoSlot) {
        const SlotId base = state_.walk.base;
        state_.walk.base = kNoSlot;
        trace_.takeBase(true);
        return base;
    }
    trace_.takeBase(false);
    SlotId base = state_.walkOrder.take(state_.front);
    while (base == kNoSlot && state_.strip + 1 < state_.stripEnd) {
        ++state_.strip;
        offerStrip();
        base = state_.walkOrder.take(state_.front);
    }
    if (base != kNoSlot) {
        state_.walk.level = state_.walkOrder.levelOf(state_.front, base);
    }
    return base;
}

/// Offers the segments in the current strip.
template <class Grid, class Trace>
void FastAdvancer<Grid, Trace>::offerStrip() {
    const FrontStrips &strips = *state_.strips;
    const std::size_t phase = strips.phaseOf(state_.strip);
    // Strips of a phase do not overlap, so meshing one does not change the lists of the later ones. Lists made in a
    // later strip than this one may be wrong here: its segments had been meshed by then.
    if (inStrips_.empty() || strips.phaseOf(listedFrom_) != phase || state_.strip < listedFrom_) {
        inStrips_ = segmentsByStrip(state_.front, strips, phase);
        listedFrom_ = state_.strip;
    }
    offerSorted(state_.walkOrder, state_.front, inStrips_[state_.strip - strips.phases[phase]]);
}

template <class Grid, class Trace>
bool FastAdvancer<Grid, Trace>::advance(AdvanceDelta &delta) {
    const Walk walk = state_.walk;
    const auto logged = static_cast<std::uint32_t>(state_.walkOrder.logSize());
    const std::uint32_t strip = state_.strip;
    for (SlotId base = nextBase(); base != kNoSlot; base = nextBase()) {
        if (tryBase(base, delta) == Outcome::Done) {
            delta.walk = walk;
            delta.logged = logged;
            delta.strip = strip;
            return true;
        }
    }
    return false;
}

template <class Grid, class Trace>
typename FastAdvancer<Grid, Trace>::Outcome FastAdvancer<Grid, Trace>::tryBase(SlotId slotA, AdvanceDelta &delta) {
    const GenerationFront &front = state_.front;
    Base base = baseAt(front, slotA);
    if (state_.strips->tooFine(state_.strip, midpoint(base.a, base.b), base.length)) {
        return Outcome::LeftToLaterStrip;
    }
    delta = update_.begin(slotA);
    search_.startCounting();
    const std::size_t segments = front.segments();
    trace_.begin(state_, base);
    Vec2 apex;
    if (!trySimple(base, delta, apex) && searchApex(base, delta, apex) == Outcome::LeftToLaterStrip) {
        return Outcome::LeftToLaterStrip;
    }
    continueWalk(delta);
    trace_.end(state_, delta, apex);
    search_.work().store(delta);
    update_.count(delta, segments, true);
    return Outcome::Done;
}

/// Returns the cosine of the free angle at a node of Γ; -1 from 180 degrees on.
template <class Grid, class Trace>
double FastAdvancer<Grid, Trace>::cosine(SlotId corner) const {
    const GenerationFront &front = state_.front;
    const SlotId before = front.prev(corner);
    const Vec2 out = front.end(corner) - front.start(corner);
    const Vec2 in = front.start(before) - front.start(corner);
    return cross(out, in) <= 0.0 ? -1.0 : dot(out, in) / (front[corner].length * front[before].length);
}

template <class Grid, class Trace>
bool FastAdvancer<Grid, Trace>::similar(SlotId first, unsigned segments) const {
    double shortest = state_.front[first].length, longest = shortest;
    SlotId id = first;
    for (unsigned i = 1; i < segments; ++i) {
        id = state_.front.next(id);
        shortest = std::min(shortest, state_.front[id].length);
        longest = std::max(longest, state_.front[id].length);
    }
    return longest < kSimilar * shortest;
}

/// Closes a corner, or makes a new node over one to three segments. Returns false if neither is possible.
template <class Grid, class Trace>
bool FastAdvancer<Grid, Trace>::trySimple(const Base &base, AdvanceDelta &delta, Vec2 &apex) {
    const GenerationFront &front = state_.front;
    const SlotId before = front.prev(base.slotA), after = front.next(base.slotB);
    const Box2 *limit = limits();
    if (limit != nullptr &&
        !(limit->containsHalfOpen(front.start(before)) && limit->containsHalfOpen(front.start(after)))) {
        return false; // the part of Γ in a strip may end beyond these nodes
    }
    const bool nearlyClosed = after == before || front.next(after) == before; // three or four segments are left
    if (nearlyClosed || front[base.slotA].mark.failureClass > 0) {
        return false;
    }
    const double atA = cosine(base.slotA), atB = cosine(base.slotB);
    const SlotId first = atB >= atA ? base.slotA : before; // the first of the two segments at the sharper corner
    if (std::max(atA, atB) > kSharp) {
        return tryCorner(base, first, delta, apex);
    }
    const auto tryAlone = [&] { return tryFan(base.slotA, 1, delta, apex); };
    if (std::max(atA, atB) < kWide) {
        return tryAlone();
    }
    const bool closesRow = std::min(atA, atB) > kThreeFrom && similar(before, 3);
    if (closesRow && tryFan(before, 3, delta, apex)) {
        return true;
    }
    if (!similar(first, 2)) {
        return tryAlone();
    }
    Fan two(front, first, 2);
    if (!fans_.place(two)) {
        return tryAlone();
    }
    const double length = 0.5 * (front[first].length + front[two.slots[1]].length);
    if (length < kShort * two.rho && ((similar(base.slotA, 3) && tryFan(base.slotA, 3, delta, apex)) ||
                                      (!closesRow && similar(before, 3) && tryFan(before, 3, delta, apex)))) {
        return true;
    }
    if (length > kLong * two.rho && std::max(atA, atB) < kRoomy) {
        return tryAlone() || makeFan(two, delta, apex);
    }
    return makeFan(two, delta, apex) || tryAlone();
}

template <class Grid, class Trace>
bool FastAdvancer<Grid, Trace>::tryCorner(const Base &base, SlotId first, AdvanceDelta &delta, Vec2 &apex) {
    const Fan corner(state_.front, first, 2);
    const Box2 *limit = limits();
    if ((limit != nullptr && !limit->containsHalfOpen(corner.box())) || !suitsSpacing(state_.front, corner)) {
        return false;
    }
    const unsigned from = first == base.slotA ? 0 : 1; // the base is the first or the second of the two segments
    trace_.proposeCorner(state_, corner, from);
    if (!fans_.cornerClear(corner, search_.work())) {
        trace_.endTest(Verdict::CrossesFront);
        ++search_.work().rejected;
        return false;
    }
    trace_.endTest(Verdict::Accepted);
    apex = corner.at[2 - 2 * from];
    update_.addElement(baseAt(state_.front, first), {0.0, corner.at[2], corner.nodes[2], corner.last()},
                       delta = update_.begin(first));
    return true;
}

template <class Grid, class Trace>
bool FastAdvancer<Grid, Trace>::tryFan(SlotId first, unsigned segments, AdvanceDelta &delta, Vec2 &apex) {
    Fan fan(state_.front, first, segments);
    return fans_.place(fan) && makeFan(fan, delta, apex);
}

template <class Grid, class Trace>
bool FastAdvancer<Grid, Trace>::makeFan(const Fan &fan, AdvanceDelta &delta, Vec2 &apex) {
    const Box2 reach = FanBuilder<Grid, Trace>::reach(fan);
    const Box2 *limit = limits();
    if (limit != nullptr && !limit->containsHalfOpen(reach)) {
        return false;
    }
    ++search_.work().candidates;
    trace_.proposeFan(fan);
    if (!fans_.clear(fan, reach, search_.work())) {
        trace_.endTest(Verdict::Withdrawn);
        ++search_.work().rejected;
        return false;
    }
    trace_.endTest(Verdict::Accepted);
    apex = fan.apex;
    if (fan.segments == 1) {
        delta = update_.begin(fan.slots[0]);
        update_.addElement(baseAt(state_.front, fan.slots[0]), {0.0, apex, kNoNode, kNoSlot}, delta);
    } else {
        update_.addFan(fan.chain(), apex, apex == fan.rhoThere ? fan.rho : spacing_.at(apex), delta);
    }
    return true;
}

/// Performs steps 3 to 9 as the ClassicAdvancer does. In all strips but the last, a base is left to a later strip if
/// the first search fails.
template <class Grid, class Trace>
typename FastAdvancer<Grid, Trace>::Outcome FastAdvancer<Grid, Trace>::searchApex(Base &base, AdvanceDelta &delta,
                                                                                  Vec2 &apex) {
    search_.evaluateSpacing(base);
    const bool secondTime = delta.markA.failureClass > 0;
    constexpr FrontRules kRules;
    const double radius = (secondTime ? kRules.secondRadius : kRules.radius) * base.rho;
    Candidate found;
    const Box2 *limit = limits();
    if (limit != nullptr) {
        if (base.small() || !limit->containsHalfOpen(ApexSearch<Grid, Trace>::reach(base, radius)) ||
            !search_.find(base, {radius, true}, found) || !mayConnect(found)) {
            return Outcome::LeftToLaterStrip;
        }
    } else if (!search_.find(base, {radius, true}, found)) {
        if (!secondTime) {
            update_.defer(base.slotA, delta);
            return Outcome::Done;
        }
        search_.force(base, radius, found);
        delta.forced = true;
    }
    update_.addElement(base, found, delta);
    apex = found.position;
    return Outcome::Done;
}

/// Returns true if the slot before the apex, whose link a connection changes, lies in the strip as well.
template <class Grid, class Trace>
bool FastAdvancer<Grid, Trace>::mayConnect(const Candidate &apex) const {
    return apex.slot == kNoSlot || limits()->containsHalfOpen(state_.front.start(state_.front.prev(apex.slot)));
}

/// Continues the walk with the last new segment along the loop unless its length class is higher than that of the walk,
/// and offers all other new segments to the order.
template <class Grid, class Trace>
void FastAdvancer<Grid, Trace>::continueWalk(const AdvanceDelta &delta) {
    const GenerationFront &front = state_.front;
    SlotId last = kNoSlot;
    FrontUpdate<Grid>::forEachNew(delta, [&](SlotId id) {
        if (last != kNoSlot) {
            state_.walkOrder.offer(front, last);
        }
        last = id;
    });
    if (last == kNoSlot) {
        return;
    }
    if (!state_.care.walks || delta.kind == AdvanceDelta::Kind::Deferral ||
        state_.walkOrder.level(front[last].length) > state_.walk.level) {
        state_.walkOrder.offer(front, last);
    } else {
        state_.walk.base = last;
    }
}

template <class Grid, class Trace>
void FastAdvancer<Grid, Trace>::retreat(const AdvanceDelta &delta) {
    update_.undo(delta);
    state_.strip = delta.strip;
    state_.walkOrder.rollBack(delta.logged);
    state_.walk = delta.walk;
}

FOREFRONT_INSTANTIATE_FOR_GRIDS_AND_TRACES(FastAdvancer)

} // namespace forefront
