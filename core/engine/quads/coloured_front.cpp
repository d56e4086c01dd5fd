#include "core/engine/quads/coloured_front.hpp"

#include "core/engine/geometry/predicates.hpp"
#include "core/engine/mesher/instantiate.hpp"

#include <cmath>
#include <numbers>

namespace forefront {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kRowCorner = 125.0 * kDegree;     ///< wider corners of Γ do not continue a row
constexpr double kSharpCorner = 55.0 * kDegree;    ///< sharper ones are closed by a search
constexpr double kMinBeside = 69.0 * kDegree;      ///< minimum free angle at the ends of a corner that continues a row
constexpr double kClosingCorner = 126.0 * kDegree; ///< maximum angle at both ends of the base of a closing square
// Minimum and maximum length of a closing segment, in ρ.
constexpr double kMinClosing = 0.5, kMaxClosingLeg = 1.55;
// Minimum and maximum ratio of a side of a new square to the opposite side; more where a row opens.
constexpr double kMinToOpposite = 0.6, kMaxToOpposite = 1.6, kMaxOpening = 1.7;
// Minimum and maximum ratio of a side to what it was to be.
constexpr double kShortestSide = 0.55, kLongestSide = 1.5;
/// Minimum distance of new nodes of squares from others, in sides; FanBuilder keeps 0.8 sizes.
constexpr double kSquareClearance = 0.62 / 0.8;
// Search radii in ρ: the first, and the one after a deferral.
constexpr double kFirstRadius = 1.75, kSecondRadius = 2.5;
constexpr std::uint32_t kDeferredLayers = 2; ///< rows that a leg waits for once no apex was found

bool positive(Vec2 a, Vec2 b, Vec2 c) {
    return orientation(a, b, c) > 0;
}

} // namespace

template <class Grid>
ColouredFront<Grid>::ColouredFront(const ColouredBoundary &boundary, const SpacingField &spacing, Grid grid,
                                   std::uint32_t rows)
    : spacing_(spacing), state_(boundary.domain), grid_(std::move(grid)), fans_(state_, grid_, spacing, trace_),
      update_(state_, grid_, &spacing), colours_(boundary.colours),
      search_(state_, grid_, spacing, colours_, opposite_, boundary.domain.nodes.size()), layers_(rows) {
    GenerationFront &front = state_.front;
    opposite_.assign(front.capacity(), kNoNode);
    for (std::uint32_t i = 0; i < front.capacity(); ++i) {
        const SlotId id{i};
        if (front[id].alive) {
            front.setRho(id, spacing.at(front.start(id)));
            grid_.insert(front, id);
        }
    }
    for (std::uint32_t i = 0; i < front.capacity(); ++i) {
        const SlotId id{i};
        if (front[id].alive && !front.isolated(id)) {
            isLegAt(id) ? layers_.offerLeg(front, id, 0) : layers_.offerDiagonal(front, id);
        }
    }
}

template <class Grid>
bool ColouredFront<Grid>::advance() {
    GenerationFront &front = state_.front;
    const SlotId id = layers_.take(front);
    if (id == kNoSlot) {
        return false;
    }
    layer_ = layers_.layerOf(id);
    const bool leg = isLegAt(id), again = front[id].mark.failureClass > 0;
    if (leg && !again && trySquare(id)) {
        return true;
    }
    Base base = baseAt(front, id);
    ColouredCandidate apex{};
    if (search_.find(base, again ? kSecondRadius : kFirstRadius, apex)) {
        ++work_.searched;
        addTriangle(base, apex.apex, apex.colour, false);
    } else if (!again) {
        AdvanceDelta delta = update_.begin(id);
        update_.defer(id, delta);
        update_.count(delta, front.segments(), true);
        leg ? layers_.offerLeg(front, id, layer_ + kDeferredLayers) : layers_.deferDiagonal(front, id);
    } else {
        search_.force(base, kSecondRadius, apex);
        ++work_.forced;
        addTriangle(base, apex.apex, apex.colour, true);
    }
    return true;
}

template <class Grid>
void ColouredFront<Grid>::setOpposite(SlotId id, NodeId node) {
    if (opposite_.size() <= index(id)) {
        opposite_.resize(2 * index(id) + 16, kNoNode);
    }
    opposite_[index(id)] = node;
}

/// Offers the segments that an advance of the row `layer` has made.
template <class Grid>
void ColouredFront<Grid>::made(const AdvanceDelta &delta, std::uint32_t layer, std::size_t segments) {
    update_.count(delta, segments, true);
    const GenerationFront &front = state_.front;
    FrontUpdate<Grid>::forEachNew(delta, [&](SlotId id) {
        const NodeId a = front[id].node, b = front[front.next(id)].node;
        setOpposite(id, kNoNode);
        for (unsigned k = 0; k < delta.elements(); ++k) {
            const Element &element = state_.elements[state_.elements.size() - 1 - k];
            for (unsigned side = 0; side < 3; ++side) {
                if (element[side] == b && element[(side + 1) % 3] == a) { // the element is on the right
                    setOpposite(id, element[(side + 2) % 3]);
                }
            }
        }
        if (isLegAt(id)) {
            layers_.offerLeg(front, id, layer + 1);
        } else {
            layers_.setLayer(id, layer);
            layers_.offerDiagonal(front, id);
        }
    });
}

template <class Grid>
void ColouredFront<Grid>::addTriangle(const Base &base, Candidate apex, std::uint8_t colour, bool forced) {
    const std::size_t segments = state_.front.segments();
    AdvanceDelta delta = update_.begin(base.slotA);
    delta.forced = forced;
    if (apex.slot == kNoSlot) {
        colours_.push_back(colour);
    }
    update_.addElement(base, apex, delta);
    made(delta, layer_, segments);
}

template <class Grid>
bool ColouredFront<Grid>::isClear(Fan &fan, double size) {
    fan.size = size * kSquareClearance;
    for (unsigned i = 0; i < fan.segments; ++i) {
        if (!positive(fan.at[i], fan.at[i + 1], fan.apex)) {
            return false;
        }
    }
    return fans_.clear(fan, FanBuilder<Grid, NoTrace>::reach(fan), tested_);
}

/// Makes a whole square at a leg, if that is simple.
template <class Grid>
bool ColouredFront<Grid>::trySquare(SlotId id) {
    const GenerationFront &front = state_.front;
    const SlotId prev = front.prev(id), next = front.next(id);
    if (front.next(next) == prev || front.next(front.next(next)) == prev) {
        return false; // loops of three and four segments
    }
    constexpr double kNoCorner = 10.0;
    const double atA = isLegAt(prev) ? freeAngle(front, id) : kNoCorner;
    const double atB = isLegAt(next) ? freeAngle(front, next) : kNoCorner;
    if (atA < kClosingCorner && atB < kClosingCorner && tryClosing(id)) {
        return true;
    }
    const double sharper = std::min(atA, atB), wider = std::max(atA, atB);
    if (sharper < kSharpCorner) {
        return false;
    }
    if (sharper >= kRowCorner) {
        return tryOpening(id);
    }
    const bool atStart = atA <= atB;
    return tryRow(atStart ? prev : id) || (wider < kRowCorner && tryRow(atStart ? id : prev));
}

/// Places the fourth node of the square over the corner P X N: at the mean of the places that the free angles at P and
/// N and the node spacing lead to. Returns false if the square would be badly shaped. `size`: mean of the new sides.
template <class Grid>
bool ColouredFront<Grid>::placeInRow(Fan &fan, double &size) const {
    const GenerationFront &front = state_.front;
    const SlotId p = fan.slots[0], n = fan.slots[2];
    const double atP = freeAngle(front, p), atN = freeAngle(front, n);
    if (atP < kMinBeside || atN < kMinBeside) {
        return false;
    }
    const Vec2 placeP = fan.at[0], x = fan.at[1], placeN = fan.at[2];
    const double rhoP = front[p].rho, rhoN = front[n].rho;
    const Vec2 parallelogram = placeP + (placeN - x); // beside another corner, which is a row's end
    const auto seen = [&](double sideP, double sideN) {
        const Vec2 fromP = atP < kRowCorner ? parallelogram : placeP + sideP * sideDirection(front, p, true);
        const Vec2 fromN = atN < kRowCorner ? parallelogram : placeN + sideN * sideDirection(front, n, false);
        return midpoint(fromP, fromN);
    };
    const double mean = (rhoP + rhoN + front[fan.slots[1]].rho) / 3.0;
    const double rho = spacing_.at(seen(mean, mean));
    const double oppositeP = distance(x, placeN), oppositeN = distance(x, placeP);
    const double sideP = std::clamp(0.5 * (rhoP + rho), kMinToOpposite * oppositeP, kMaxToOpposite * oppositeP);
    const double sideN = std::clamp(0.5 * (rhoN + rho), kMinToOpposite * oppositeN, kMaxToOpposite * oppositeN);
    const Vec2 c = seen(sideP, sideN);
    fan.apex = c;
    size = 0.5 * (sideP + sideN);
    const double gotP = distance(c, placeP), gotN = distance(c, placeN);
    return gotP >= kShortestSide * sideP && gotP <= kLongestSide * sideP && gotN >= kShortestSide * sideN &&
           gotN <= kLongestSide * sideN && positive(placeP, x, placeN) && positive(placeN, c, placeP);
}

/// Continues a row: the square over the corner of two successive legs, with one new node.
template <class Grid>
bool ColouredFront<Grid>::tryRow(SlotId first) {
    Fan fan(state_.front, first, 2);
    double size = 0.0;
    if (!placeInRow(fan, size) || !isClear(fan, size)) {
        return false;
    }
    const double rho = spacing_.at(fan.apex);
    if (size < kSmallNode * rho) {
        return false;
    }
    const std::size_t segments = state_.front.segments();
    AdvanceDelta delta = update_.begin(first);
    colours_.push_back(colours_[index(fan.nodes[1])]);
    update_.addFan(fan.chain(), fan.apex, rho, delta);
    ++work_.rows;
    made(delta, layer_, segments);
    return true;
}

/// Starts a row: a square over a leg, with two new nodes.
template <class Grid>
bool ColouredFront<Grid>::tryOpening(SlotId id) {
    const GenerationFront &front = state_.front;
    const SlotId end = front.next(id);
    const Vec2 a = front.start(id), b = front.start(end);
    const double l = front[id].length, rhoA = front[id].rho, rhoB = front[end].rho;
    const Vec2 alongA = sideDirection(front, id, true), alongB = sideDirection(front, end, false);
    const auto clamped = [l](double rho) { return std::clamp(rho, kMinToOpposite * l, kMaxOpening * l); };
    const double rhoD = spacing_.at(a + clamped(rhoA) * alongA), rhoC = spacing_.at(b + clamped(rhoB) * alongB);
    const double sideA = clamped(0.5 * (rhoA + rhoD)), sideB = clamped(0.5 * (rhoB + rhoC));
    Vec2 d = a + sideA * alongA, c = b + sideB * alongB;
    // The far side goes half-way to the spacing there.
    const double far = distance(d, c);
    const double wanted = std::clamp(0.5 * (rhoC + rhoD), kMinToOpposite * l, kMaxToOpposite * l);
    if (far > 0.0) {
        const Vec2 pull = 0.25 * (wanted / far - 1.0) * (c - d);
        d = d - pull;
        c = c + pull;
    }
    const double size = 0.5 * (sideA + sideB);
    Fan first(front, id, 1), second(front, id, 1);
    first.apex = c;
    second.apex = d;
    if (!positive(a, c, d) || tooSmall(size, c) || tooSmall(size, d) || !isClear(first, size) ||
        !isClear(second, size)) {
        return false;
    }
    const std::uint8_t colourA = colours_[index(front[id].node)];
    const std::uint32_t layer = layer_;
    std::size_t segments = front.segments();
    AdvanceDelta half = update_.begin(id);
    colours_.push_back(colourA);
    update_.addElement(baseAt(front, id), {0.0, c, kNoNode, kNoSlot}, half);
    made(half, layer, segments); // the diagonal is taken next, but not by a search
    segments = front.segments();
    AdvanceDelta other = update_.begin(id);
    colours_.push_back(static_cast<std::uint8_t>(1 - colourA));
    update_.addElement(baseAt(front, id), {0.0, d, kNoNode, kNoSlot}, other);
    made(other, layer, segments);
    layers_.offerLeg(front, half.s, layer); // the rest of this row starts here
    ++work_.openings;
    return true;
}

/// Closes P A B N with the segment P N: a square without a new node.
template <class Grid>
bool ColouredFront<Grid>::tryClosing(SlotId id) {
    const GenerationFront &front = state_.front;
    const SlotId p = front.prev(id), b = front.next(id), n = front.next(b);
    const Vec2 placeP = front.start(p), placeA = front.start(id), placeB = front.start(b), placeN = front.start(n);
    const double rho = 0.5 * (front[p].rho + front[n].rho), l = distance(placeP, placeN);
    if (l < kMinClosing * rho || l > kMaxClosingLeg * rho || !positive(placeP, placeA, placeB) ||
        !positive(placeA, placeB, placeN) || !positive(placeP, placeB, placeN) || !positive(placeN, placeP, placeA)) {
        return false;
    }
    for (unsigned half = 0; half < 2; ++half) {
        const Fan corner(front, p, 2);
        if (!fans_.cornerClear(corner, tested_)) {
            return half > 0; // the diagonal goes through a search
        }
        const std::size_t segments = front.segments();
        AdvanceDelta delta = update_.begin(p);
        update_.addElement(baseAt(front, p), {0.0, corner.at[2], corner.nodes[2], corner.slots[2]}, delta);
        made(delta, layer_, segments);
    }
    ++work_.closings;
    return true;
}

FOREFRONT_INSTANTIATE_FOR_GRIDS(ColouredFront)

} // namespace forefront
