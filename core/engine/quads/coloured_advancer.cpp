#include "core/engine/quads/coloured_advancer.hpp"

#include "core/engine/quads/quad_cell.hpp"
#include "core/engine/quads/square_places.hpp"

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kSharpCorner = 55.0 * kDegree;    ///< sharper ones are closed by a search
constexpr double kClosingCorner = 126.0 * kDegree; ///< maximum angle at both ends of the base of a closing square
// Minimum and maximum length of a closing segment, in ρ.
constexpr double kMinClosing = 0.5, kMaxClosingLeg = 1.55;
/// Minimum distance of new nodes of squares from others, in sides; FanBuilder keeps 0.8 sizes.
constexpr double kSquareClearance = 0.62 / 0.8;
// Search radii in ρ: the first, and the one after a deferral.
constexpr double kFirstRadius = 1.75, kSecondRadius = 2.5;
constexpr std::uint32_t kDeferredLayers = 2; ///< rows that a leg waits for once no apex was found

} // namespace

template <class Grid, class Trace>
void ColouredAdvancer<Grid, Trace>::prepare(FrontState &state, ColouredState &coloured, const SpacingField &spacing) {
    GenerationFront &front = state.front;
    coloured.opposite.assign(front.capacity(), kNoNode);
    front.forEachSlot([&](SlotId id) { front.setRho(id, spacing.at(front.start(id))); });
    front.forEachSlot([&](SlotId id) {
        if (!front.isolated(id)) {
            isLeg(front, coloured.colours, id) ? coloured.layers.offerLeg(front, id, 0)
                                               : coloured.layers.offerDiagonal(front, id);
        }
    });
}

template <class Grid, class Trace>
bool ColouredAdvancer<Grid, Trace>::advance(AdvanceDelta &delta) {
    GenerationFront &front = state_.front;
    const ColouredState::Logged before = {static_cast<std::uint32_t>(coloured_.halves.size()),
                                          static_cast<std::uint32_t>(coloured_.replaced.size()),
                                          coloured_.layers.logSize()};
    const SlotId id = coloured_.layers.take(front);
    if (id == kNoSlot) {
        return false;
    }
    if (coloured_.logging) {
        coloured_.log.push_back(before);
    }
    ++coloured_.advances;
    changes_ = 0;
    work_ = {};
    layer_ = coloured_.layers.layerOf(id);
    const bool leg = isLegAt(id), again = front[id].mark.failureClass > 0;
    Base base = baseAt(front, id);
    trace_.beginBase(state_, base, coloured_.advances, !leg, layer_);
    Outcome outcome;
    if (!leg || again || !trySquare(id, outcome)) {
        searchApex(base, again, outcome);
    }
    finish(outcome, delta);
    return true;
}

/// Makes half a square at any base, by a search, or defers it.
template <class Grid, class Trace>
void ColouredAdvancer<Grid, Trace>::searchApex(Base &base, bool again, Outcome &outcome) {
    ColouredCandidate apex{};
    if (search_.find(base, again ? kSecondRadius : kFirstRadius, apex, work_)) {
        outcome = {&ColouredWork::searched, SquareKind::None, apex.apex.position};
        addTriangle(base, apex.apex, apex.colour, false);
        return;
    }
    if (again) {
        search_.force(base, kSecondRadius, apex, work_);
        outcome = {&ColouredWork::forced, SquareKind::None, apex.apex.position};
        addTriangle(base, apex.apex, apex.colour, true);
        return;
    }
    const GenerationFront &front = state_.front;
    const SlotId id = base.slotA;
    AdvanceDelta &delta = halves_[changes_++] = update_.begin(id);
    update_.defer(id, delta);
    work_.store(delta);
    update_.count(delta, front.segments(), true);
    isLegAt(id) ? coloured_.layers.offerLeg(front, id, layer_ + kDeferredLayers)
                : coloured_.layers.deferDiagonal(front, id);
}

/// Makes one delta of what the advance has changed, counts it and ends its record.
template <class Grid, class Trace>
void ColouredAdvancer<Grid, Trace>::finish(const Outcome &outcome, AdvanceDelta &delta) {
    delta = halves_[0];
    if (changes_ == 2) {
        const AdvanceDelta &second = halves_[1];
        delta.kind =
            delta.kind == AdvanceDelta::Kind::NewNode ? AdvanceDelta::Kind::Opening : AdvanceDelta::Kind::Closing;
        delta.smallNode = false; // counted with its halves
        delta.rejected = static_cast<std::uint8_t>(std::min(delta.rejected + second.rejected, 255));
        delta.delivered += second.delivered;
        delta.considered += second.considered;
        delta.tested += second.tested;
        delta.cells += second.cells;
        delta.candidates += second.candidates;
    }
    if (outcome.count != nullptr) {
        ++(coloured_.work.*outcome.count);
    }
    if (coloured_.logging) {
        coloured_.log.back().made = outcome.count;
        if (changes_ == 2) {
            coloured_.halves.insert(coloured_.halves.end(), halves_.begin(), halves_.end());
        }
    }
    trace_.endAdvance(state_, delta, outcome.apex, outcome.square);
}

template <class Grid, class Trace>
void ColouredAdvancer<Grid, Trace>::retreat(const AdvanceDelta &delta) {
    using Kind = AdvanceDelta::Kind;
    const ColouredState::Logged logged = coloured_.log.back();
    coloured_.log.pop_back();
    --coloured_.advances;
    if (logged.made != nullptr) {
        --(coloured_.work.*logged.made);
    }
    if (delta.kind == Kind::Opening || delta.kind == Kind::Closing) {
        while (coloured_.halves.size() > logged.halves) {
            update_.undo(coloured_.halves.back());
            coloured_.halves.pop_back();
        }
    } else {
        update_.undo(delta);
    }
    coloured_.colours.resize(state_.nodes.size());
    while (coloured_.replaced.size() > logged.replaced) {
        const ColouredState::Replaced &replaced = coloured_.replaced.back();
        coloured_.opposite[index(replaced.slot)] = replaced.before;
        coloured_.replaced.pop_back();
    }
    coloured_.layers.rollBack(logged.layers);
}

template <class Grid, class Trace>
void ColouredAdvancer<Grid, Trace>::setOpposite(SlotId id, NodeId node) {
    std::vector<NodeId> &opposite = coloured_.opposite;
    if (opposite.size() <= index(id)) {
        opposite.resize(2 * index(id) + 16, kNoNode);
    }
    if (coloured_.logging) {
        coloured_.replaced.push_back({id, opposite[index(id)]});
    }
    opposite[index(id)] = node;
}

/// Offers the segments that a change of the row `layer` has made, and counts it.
template <class Grid, class Trace>
void ColouredAdvancer<Grid, Trace>::made(AdvanceDelta &delta, std::uint32_t layer, std::size_t segments) {
    work_.store(delta);
    work_ = {};
    update_.count(delta, segments, true);
    const GenerationFront &front = state_.front;
    FrontUpdate<Grid>::forEachNew(delta, [&](SlotId id) {
        const NodeId a = front[id].node, b = front[front.next(id)].node;
        NodeId opposite = kNoNode;
        for (unsigned k = 0; k < delta.elements(); ++k) {
            const Element &element = state_.elements[state_.elements.size() - 1 - k];
            for (unsigned side = 0; side < 3; ++side) {
                if (element[side] == b && element[(side + 1) % 3] == a) { // the element is on the right
                    opposite = element[(side + 2) % 3];
                }
            }
        }
        setOpposite(id, opposite);
        if (isLegAt(id)) {
            coloured_.layers.offerLeg(front, id, layer + 1);
        } else {
            coloured_.layers.setLayer(id, layer);
            coloured_.layers.offerDiagonal(front, id);
        }
    });
    halves_[changes_++] = delta;
}

template <class Grid, class Trace>
void ColouredAdvancer<Grid, Trace>::addTriangle(const Base &base, Candidate apex, std::uint8_t colour, bool forced) {
    const std::size_t segments = state_.front.segments();
    AdvanceDelta delta = update_.begin(base.slotA);
    delta.forced = forced;
    if (apex.slot == kNoSlot) {
        coloured_.colours.push_back(colour);
    }
    update_.addElement(base, apex, delta);
    made(delta, layer_, segments);
}

template <class Grid, class Trace>
bool ColouredAdvancer<Grid, Trace>::isClear(Fan &fan, double size) {
    fan.size = size * kSquareClearance;
    for (unsigned i = 0; i < fan.segments; ++i) {
        if (!turnsLeft(fan.at[i], fan.at[i + 1], fan.apex)) {
            return false;
        }
    }
    return fans_.clear(fan, FanBuilder<Grid, typename Trace::Fans>::reach(fan), work_);
}

/// Ends the proposal of a square that is not made. Returns false.
template <class Grid, class Trace>
bool ColouredAdvancer<Grid, Trace>::refuse(Verdict why) {
    ++work_.rejected;
    trace_.endTest(why);
    return false;
}

/// Makes a whole square at a leg, if that is simple.
template <class Grid, class Trace>
bool ColouredAdvancer<Grid, Trace>::trySquare(SlotId id, Outcome &outcome) {
    const GenerationFront &front = state_.front;
    const SlotId prev = front.prev(id), next = front.next(id);
    if (front.next(next) == prev || front.next(front.next(next)) == prev) {
        return false; // loops of three and four segments
    }
    constexpr double kNoCorner = 10.0;
    const double atA = isLegAt(prev) ? freeAngle(front, id) : kNoCorner;
    const double atB = isLegAt(next) ? freeAngle(front, next) : kNoCorner;
    if (atA < kClosingCorner && atB < kClosingCorner && tryClosing(id, outcome)) {
        return true;
    }
    const double sharper = std::min(atA, atB), wider = std::max(atA, atB);
    if (sharper < kSharpCorner) {
        return false;
    }
    if (sharper >= kRowCorner) {
        return tryOpening(id, outcome);
    }
    const bool atStart = atA <= atB;
    return tryRow(atStart ? prev : id, outcome) || (wider < kRowCorner && tryRow(atStart ? id : prev, outcome));
}

template <class Grid, class Trace>
void ColouredAdvancer<Grid, Trace>::proposeRow(const Fan &fan, double size) {
    if constexpr (Trace::kRecords) {
        trace_.proposeSquare(
            {.kind = SquareKind::Row,
             .over = {fan.at.data(), 3},
             .corner = fan.apex,
             .second = fan.apex,
             .side = size,
             .shape = scaledJacobian({0, 1, 2, 3}, std::array{fan.at[0], fan.at[1], fan.at[2], fan.apex}),
             .colour = coloured_.colours[index(fan.nodes[1])]});
    }
}

/// Continues a row: the square over the corner of two successive legs, with one new node.
template <class Grid, class Trace>
bool ColouredAdvancer<Grid, Trace>::tryRow(SlotId first, Outcome &outcome) {
    Fan fan(state_.front, first, 2);
    double size = 0.0;
    const bool placed = placeInRow(state_.front, spacing_, fan, size);
    proposeRow(fan, size);
    if (!placed) {
        return refuse(Verdict::BadShape);
    }
    if (!isClear(fan, size)) {
        return refuse(Verdict::Withdrawn);
    }
    const double rho = spacing_.at(fan.apex);
    if (size < kSmallNode * rho) {
        return refuse(Verdict::BadShape);
    }
    trace_.endTest(Verdict::Accepted);
    const std::size_t segments = state_.front.segments();
    AdvanceDelta delta = update_.begin(first);
    coloured_.colours.push_back(coloured_.colours[index(fan.nodes[1])]);
    update_.addFan(fan.chain(), fan.apex, rho, delta);
    made(delta, layer_, segments);
    outcome = {&ColouredWork::rows, SquareKind::Row, fan.apex};
    return true;
}

template <class Grid, class Trace>
void ColouredAdvancer<Grid, Trace>::proposeOpening(const Fan &overB, const Fan &overA, double size) {
    if constexpr (Trace::kRecords) {
        const Vec2 a = overB.at[0], b = overB.at[1];
        trace_.proposeSquare({.kind = SquareKind::Opening,
                              .over = {overB.at.data(), 2},
                              .corner = overB.apex,
                              .second = overA.apex,
                              .side = size,
                              .shape = scaledJacobian({0, 1, 2, 3}, std::array{a, b, overB.apex, overA.apex}),
                              .colour = coloured_.colours[index(overB.nodes[0])]});
    }
}

/// Starts a row: a square over a leg, with two new nodes.
template <class Grid, class Trace>
bool ColouredAdvancer<Grid, Trace>::tryOpening(SlotId id, Outcome &outcome) {
    Fan overB(state_.front, id, 1), overA(state_.front, id, 1);
    double size = 0.0;
    const bool placed = placeOpening(state_.front, spacing_, id, overB, overA, size);
    proposeOpening(overB, overA, size);
    if (!placed) {
        return refuse(Verdict::BadShape);
    }
    Fan far = overA; // the half beyond the diagonal: a node there lies in neither of the two triangles over the leg
    far.at[1] = overB.apex;
    if (!isClear(overB, size) || !isClear(overA, size) || !isClear(far, size)) {
        return refuse(Verdict::Withdrawn);
    }
    trace_.endTest(Verdict::Accepted);
    addOpening(id, overB, overA);
    outcome = {&ColouredWork::openings, SquareKind::Opening, overB.apex};
    return true;
}

template <class Grid, class Trace>
void ColouredAdvancer<Grid, Trace>::addOpening(SlotId id, const Fan &overB, const Fan &overA) {
    const GenerationFront &front = state_.front;
    const std::uint8_t colourA = coloured_.colours[index(front[id].node)];
    const std::uint32_t layer = layer_;
    std::size_t segments = front.segments();
    AdvanceDelta half = update_.begin(id);
    coloured_.colours.push_back(colourA);
    update_.addElement(baseAt(front, id), {0.0, overB.apex, kNoNode, kNoSlot}, half);
    made(half, layer, segments); // the diagonal is taken next, but not by a search
    segments = front.segments();
    AdvanceDelta other = update_.begin(id);
    coloured_.colours.push_back(static_cast<std::uint8_t>(1 - colourA));
    update_.addElement(baseAt(front, id), {0.0, overA.apex, kNoNode, kNoSlot}, other);
    made(other, layer, segments);
    coloured_.layers.offerLeg(front, half.s, layer); // the rest of this row starts here
}

/// Closes P A B N with the segment P N: a square without a new node.
template <class Grid, class Trace>
bool ColouredAdvancer<Grid, Trace>::tryClosing(SlotId id, Outcome &outcome) {
    const GenerationFront &front = state_.front;
    const SlotId p = front.prev(id), b = front.next(id), n = front.next(b);
    const std::array<Vec2, 4> at = {front.start(p), front.start(id), front.start(b), front.start(n)};
    const double rho = 0.5 * (front[p].rho + front[n].rho), l = distance(at[0], at[3]);
    if constexpr (Trace::kRecords) {
        trace_.proposeSquare({.kind = SquareKind::Closing,
                              .over = at,
                              .node = front[n].node,
                              .corner = at[3],
                              .second = at[0],
                              .side = rho,
                              .shape = scaledJacobian({0, 1, 2, 3}, at),
                              .colour = coloured_.colours[index(front[n].node)]});
    }
    if (l < kMinClosing * rho || l > kMaxClosingLeg * rho || !turnsLeft(at[0], at[1], at[2]) ||
        !turnsLeft(at[1], at[2], at[3]) || !turnsLeft(at[0], at[2], at[3]) || !turnsLeft(at[3], at[0], at[1])) {
        return refuse(Verdict::BadShape);
    }
    const Base base = baseAt(front, id);
    const Fan corner(front, p, 2);
    if (!fans_.cornerClear(corner, work_)) {
        return refuse(Verdict::CrossesFront);
    }
    std::size_t segments = front.segments();
    AdvanceDelta half = closeCorner(corner);
    const Fan other(front, p, 2);
    const bool whole = fans_.cornerClear(other, work_);
    if (!whole) {
        refuse(Verdict::CrossesFront);
    }
    made(half, layer_, segments); // with the work of both tests
    if (!whole) {                 // its diagonal goes through a search
        trace_.keepHalf(base, [&] { return search_.existing(base, rho, corner.nodes[0], at[0]); });
        outcome = {&ColouredWork::searched, SquareKind::None, at[0]};
        return true;
    }
    segments = front.segments();
    AdvanceDelta second = closeCorner(other);
    made(second, layer_, segments);
    trace_.endTest(Verdict::Accepted);
    outcome = {&ColouredWork::closings, SquareKind::Closing, at[3]};
    return true;
}

/// Cuts off a corner of Γ by an element without a new node. Returns the change, which is not counted yet.
template <class Grid, class Trace>
AdvanceDelta ColouredAdvancer<Grid, Trace>::closeCorner(const Fan &corner) {
    AdvanceDelta delta = update_.begin(corner.slots[0]);
    update_.addElement(baseAt(state_.front, corner.slots[0]), {0.0, corner.at[2], corner.nodes[2], corner.slots[2]},
                       delta);
    return delta;
}

FOREFRONT_INSTANTIATE_FOR_SQUARES(ColouredAdvancer)

} // namespace forefront
