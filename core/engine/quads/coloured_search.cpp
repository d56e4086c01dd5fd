#include "core/engine/quads/coloured_search.hpp"

#include "core/engine/geometry/flat.hpp"
#include "core/engine/geometry/predicates.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesher/clearance.hpp"
#include "core/engine/mesher/instantiate.hpp"
#include "core/engine/mesher/side_tests.hpp"

#include <cmath>
#include <numbers>

namespace forefront {

namespace {

constexpr double kRightAngle = 0.5 * std::numbers::pi;
// Minimum distances of a new node from nodes and segments of Γ, in ρ.
constexpr double kQuadNodeClearance = 0.62;
constexpr double kQuadSegmentClearance = 0.5;
constexpr double kMaxLeg = 1.8;      ///< of the length of the base
constexpr double kKnownBonus = 1.15; ///< existing nodes close the front, which makes no new irregular nodes
constexpr double kStraight = 2.6;    ///< 149 degrees: wider corners of the boundary must not be one quadrilateral's
constexpr double kOneColour = 0.05;  ///< factor of scores of elements whose nodes have one colour

/// Returns how near the corner r of the triangle r, u, v is to half a square: 1 for a right angle between equal legs.
double halfSquare(Vec2 r, Vec2 u, Vec2 v) {
    const Vec2 e = u - r, f = v - r;
    const double sum = lengthSquared(e) + lengthSquared(f);
    return sum > 0.0 ? 2.0 * cross(e, f) / sum : 0.0;
}

} // namespace

double freeAngle(const GenerationFront &front, SlotId id) {
    const Vec2 out = front.end(id) - front.start(id), in = front.start(front.prev(id)) - front.start(id);
    const double angle = std::atan2(cross(out, in), dot(out, in));
    return angle <= 0.0 ? angle + 2.0 * std::numbers::pi : angle;
}

Vec2 sideDirection(const GenerationFront &front, SlotId id, bool besideOutgoing) {
    const double free = freeAngle(front, id);
    const double turn = free / std::max(1.0, std::round(free / kRightAngle)) * (besideOutgoing ? 1.0 : -1.0);
    Vec2 along = (besideOutgoing ? front.end(id) : front.start(front.prev(id))) - front.start(id);
    along = (1.0 / length(along)) * along;
    const double c = std::cos(turn), s = std::sin(turn);
    return {c * along.x - s * along.y, s * along.x + c * along.y};
}

template <class Grid, class Trace>
void ColouredSearch<Grid, Trace>::placeIdeals(Base &base) {
    const std::uint8_t colourA = colour(base.nodeA), colourB = colour(base.nodeB);
    const double l = base.length;
    const Vec2 middle = midpoint(base.a, base.b), normal = (1.0 / l) * leftNormal(base.b - base.a);
    const double atMiddle = spacing_.at(middle);
    ideals_.clear();
    if (colourA == colourB) {
        base.fieldRho = 0.5 * (atMiddle + spacing_.at(middle + std::max(0.3 * l, 0.7 * atMiddle) * normal));
        base.rho = std::clamp(base.fieldRho, 0.55 * l, 1.5 * l);
        const double height = std::sqrt(std::max(base.rho * base.rho - 0.25 * l * l, 0.09 * l * l));
        base.ideal = middle + height * normal;
        const auto other = static_cast<std::uint8_t>(1 - colourA);
        ideals_.push_back({base.ideal, other});
        ideals_.push_back({middle + 0.5 * l * normal, other}); // a square, where there is no room for longer sides
        return;
    }
    base.fieldRho = 0.5 * (atMiddle + spacing_.at(middle + atMiddle * normal));
    base.rho = std::clamp(base.fieldRho, 0.55 * l, kMaxLeg * l);
    ideals_.push_back({base.b + base.rho * sideDirection(state_.front, base.slotB, false), colourA});
    ideals_.push_back({base.a + base.rho * sideDirection(state_.front, base.slotA, true), colourB});
    base.ideal = middle + 0.8 * base.rho * normal;
}

/// Collects the segments of Γ near the box, each once, in the order of their slots: the same for every grid.
template <class Grid, class Trace>
void ColouredSearch<Grid, Trace>::gather(const Box2 &box, SearchWork &work) {
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
            ++work.delivered;
            trace_.deliver(1);
            std::uint32_t &stamp = stamps_[index(id)];
            if (stamp != stamp_) {
                stamp = stamp_;
                if (near && segmentNearBox(front.start(id), front.end(id), box)) {
                    found_.push_back(id);
                }
            }
        },
        [&](const Box2 &cell) {
            ++work.cells;
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

template <class Grid, class Trace>
bool ColouredSearch<Grid, Trace>::find(Base &base, double radius, ColouredCandidate &apex, SearchWork &work) {
    placeIdeals(base);
    trace_.evaluateSpacing(base);
    return look(base, {radius * base.rho, true, false}, apex, work);
}

template <class Grid, class Trace>
void ColouredSearch<Grid, Trace>::force(Base &base, double radius, ColouredCandidate &apex, SearchWork &work) {
    constexpr std::size_t kMaxSeen = 4096; // bounds the cost of bases that have no other choice
    const GenerationFront &front = state_.front;
    placeIdeals(base);
    radius *= base.rho;
    bool flat = front.prev(base.slotA) == front.next(base.slotB); // the last element of a loop
    do { // ends at the latest when the search covers all of Γ, see ClassicAdvancer
        radius *= 2.0;
        trace_.widen();
        FOREFRONT_ASSERT(std::isfinite(radius));
        flat = flat || neighbours_.size() > kMaxSeen || neighbours_.size() >= front.slots();
    } while (!look(base, {radius, false, flat}, apex, work));
}

template <class Grid, class Trace>
ColouredCandidate ColouredSearch<Grid, Trace>::candidate(const Base &base, const Neighbour &n) const {
    const std::uint8_t c = colour(n.nodeA);
    const ColouredScore figures = score(base, n.a, c);
    return {{kKnownBonus * figures.product(), n.a, n.nodeA, n.slot}, c, figures};
}

template <class Grid, class Trace>
ColouredCandidate ColouredSearch<Grid, Trace>::existing(Base base, double rho, NodeId node, Vec2 at) const {
    base.rho = rho;
    return candidate(base, {kNoSlot, node, node, at, at});
}

/// Collects the candidates within a radius in domain units, best score first, ties by id.
template <class Grid, class Trace>
void ColouredSearch<Grid, Trace>::propose(const Base &base, const Limits &limits) {
    candidates_.clear();
    const bool diagonal = colour(base.nodeA) == colour(base.nodeB);
    for (const Neighbour &n : neighbours_) {
        if (n.nodeA == base.nodeA || n.nodeA == base.nodeB ||
            distanceSquared(n.a, base.ideal) > limits.radius * limits.radius) {
            continue;
        }
        // Only if there is no other choice.
        const bool oneColour = limits.newNodes && diagonal && colour(n.nodeA) == colour(base.nodeA);
        if (oneColour || (limits.newNodes && flattensCorner(base, n))) {
            trace_.skip([&] { return candidate(base, n); }, oneColour ? Verdict::OneColour : Verdict::FlatCorner);
            continue;
        }
        candidates_.push_back(candidate(base, n));
    }
    if (limits.newNodes && (state_.smallNodesLeft > 0 || !base.small())) {
        for (const Ideal &ideal : ideals_) {
            const auto here = [&] {
                const ColouredScore figures = score(base, ideal.at, ideal.colour);
                return ColouredCandidate{{figures.product(), ideal.at, kNoNode, kNoSlot}, ideal.colour, figures};
            };
            if (const std::optional<Obstacle> near = obstacle(base, ideal.at)) {
                trace_.skip(here, Verdict::Withdrawn, *near);
            } else {
                candidates_.push_back(here());
            }
        }
    }
    std::stable_sort(
        candidates_.begin(), candidates_.end(),
        [](const ColouredCandidate &p, const ColouredCandidate &q) { return p.apex.score > q.apex.score; });
}

/// Tests the candidates within a radius in domain units, best score first, ties by id.
template <class Grid, class Trace>
bool ColouredSearch<Grid, Trace>::look(const Base &base, const Limits &limits, ColouredCandidate &apex,
                                       SearchWork &work) {
    Box2 box = boxAround(base.ideal, limits.radius);
    box.add(base.a);
    box.add(base.b);
    for (const Ideal &ideal : ideals_) {
        box.add(ideal.at);
    }
    gather(box, work);
    propose(base, limits);
    work.candidates += static_cast<std::uint32_t>(candidates_.size());
    trace_.rankSearch(base, candidates_, limits.radius);
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
        trace_.beginTest(i);
        const Verdict verdict = test(base, candidates_[i].apex, limits.flat, work);
        trace_.endTest(verdict);
        if (verdict == Verdict::Accepted) {
            apex = candidates_[i];
            return true;
        }
        ++work.rejected;
    }
    return false;
}

/// Returns what is too near for a new node, a node of Γ (both ends are it) or a segment; null: nothing.
template <class Grid, class Trace>
std::optional<Obstacle> ColouredSearch<Grid, Trace>::obstacle(const Base &base, Vec2 p) const {
    const double node2 = kQuadNodeClearance * kQuadNodeClearance * base.rho * base.rho;
    const double segment2 = kQuadSegmentClearance * kQuadSegmentClearance * base.rho * base.rho;
    for (const Neighbour &n : neighbours_) {
        if (n.slot == base.slotA) {
            continue;
        }
        const bool own = n.nodeA == base.nodeA || n.nodeA == base.nodeB;
        if (!own && distanceSquared(p, n.a) < node2) {
            return Obstacle{n.a, n.a, kQuadNodeClearance * base.rho};
        }
        if (nearSegment(p, n.a, n.b, segment2)) {
            return Obstacle{n.a, n.b, kQuadSegmentClearance * base.rho};
        }
    }
    return std::nullopt;
}

/// Returns true if the second half over a diagonal would take the whole of a nearly straight angle of the boundary as
/// one corner: where an acute corner is closed first, that is the next node along its side.
template <class Grid, class Trace>
bool ColouredSearch<Grid, Trace>::flattensCorner(const Base &base, const Neighbour &n) const {
    const NodeId third = opposite_[index(base.slotA)];
    if (colour(base.nodeA) != colour(base.nodeB) || third == kNoNode) {
        return false;
    }
    const GenerationFront &front = state_.front;
    const auto wholeAngle = [&](NodeId node, Vec2 at) { // between the first half's other side and the new one
        const Vec2 u = state_.nodes[index(third)] - at, v = n.a - at;
        return index(node) < fixed_ ? std::fabs(std::atan2(cross(u, v), dot(u, v))) : 0.0;
    };
    return (front.next(base.slotB) == n.slot && wholeAngle(base.nodeB, base.b) > kStraight) ||
           (front.prev(base.slotA) == n.slot && wholeAngle(base.nodeA, base.a) > kStraight);
}

template <class Grid, class Trace>
ColouredScore ColouredSearch<Grid, Trace>::score(const Base &base, Vec2 p, std::uint8_t c) const {
    const std::uint8_t colourA = colour(base.nodeA);
    const auto deltaTo = [&](Vec2 end) { return spacingConformity(distance(end, p), base.rho); };
    if (colourA == colour(base.nodeB)) {
        return c == colourA ? ColouredScore{kOneColour * shapeFactor(base.a, base.b, p)}
                            : ColouredScore{halfSquare(p, base.a, base.b), deltaTo(base.a), deltaTo(base.b)};
    }
    return c == colourA ? ColouredScore{halfSquare(base.b, p, base.a), 1.0, deltaTo(base.b)}
                        : ColouredScore{halfSquare(base.a, base.b, p), deltaTo(base.a), 1.0};
}

template <class Grid, class Trace>
Verdict ColouredSearch<Grid, Trace>::test(const Base &base, const Candidate &apex, bool flat, SearchWork &work) {
    if (flat ? orientation(base.a, base.b, apex.position) <= 0
             : isFlat(base.a, base.b, apex.position, kAvoidedFlatness)) {
        return Verdict::NotLeft;
    }
    const Verdict sides = testSides(state_.front, neighbours_, base, apex, trace_, work);
    if (sides != Verdict::Accepted) {
        return sides;
    }
    return containsNode(base, apex, flat) ? Verdict::ContainsNode : Verdict::Accepted;
}

template <class Grid, class Trace>
bool ColouredSearch<Grid, Trace>::containsNode(const Base &base, const Candidate &apex, bool flat) {
    Box2 box = boxOf(base.a, base.b);
    box.add(apex.position);
    box = box.grown(roundingMargin(box));
    const Vec2 c = apex.position;
    for (const Neighbour &n : neighbours_) {
        if (n.nodeA == base.nodeA || n.nodeA == base.nodeB || n.nodeA == apex.node || !box.contains(n.a)) {
            continue;
        }
        if (insideOrOn(base.a, base.b, c, n.a) ||
            (!flat && (nearlyOnSegment(base.a, c, n.a) || nearlyOnSegment(base.b, c, n.a)))) {
            trace_.block(n.a, n.a);
            return true;
        }
    }
    return false;
}

FOREFRONT_INSTANTIATE_FOR_SQUARES(ColouredSearch)

} // namespace forefront
