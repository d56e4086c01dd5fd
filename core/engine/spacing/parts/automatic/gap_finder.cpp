#include "core/engine/spacing/parts/automatic/gap_finder.hpp"

#include "core/engine/base/rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace forefront {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();
constexpr double kFacing = 0.5;                  ///< cosine of the widest angle to the normal
constexpr double kSteepest = 1.7320508075688772; ///< √3, its tangent
constexpr double kSafely = 1.0 + 1e-9;           ///< for rounding errors
constexpr double kAlmost = 1.0 + 1e-6;           ///< likewise, of lengths along chains
/// Beside a sharp corner the width falls to zero; parts there are at least this fraction of their reach.
constexpr double kCornerFloor = 0.125;
constexpr double kNeedle = 0.9396926207859084; ///< cosine of 20 degrees
/// Gaps and tips of needles narrower than this fraction of their reach are left to the spacing around them. However
/// fine the elements, some remain poor, and finer elements only add to their number: a needle of angle θ and elements
/// of one size has about 2/θ.
constexpr double kNegligibleGap = 1.0 / 32.0;
/// The width may vary by this factor along a part. Sizes that follow the width in coarser steps alternate between two
/// rows of elements and more, with irregular ones in between.
constexpr double kSameWidth = 1.05;
/// Likewise beside curves. There the width grows faster and faster, and sizes that follow it closely leave irregular
/// elements where a cusp begins.
constexpr double kSameWidthAtCurve = 1.2;
constexpr double kRounding = 4e-15; ///< of the coordinates, in distances between segments
constexpr double kLongGap = 12.0;   ///< in widths; a shorter gap, between two tips, costs few elements

struct Pair {
    Vec2 p;
    Vec2 q;
    double square = kNothing;
};

Vec2 nearestOn(Vec2 a, Vec2 b, Vec2 p) {
    return SizeSite::segment(a, b, 1.0, 0.0).nearest(p);
}

/// Returns the closest points of two segments that do not cross; at least one of the points is an end. `first` is the
/// segment from a to b.
Pair closest(const SizeSite &first, Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const SizeSite second = SizeSite::segment(c, d, 1.0, 0.0);
    Pair best;
    const auto consider = [&](Vec2 p, Vec2 q) {
        const double square = distanceSquared(p, q);
        if (square < best.square) {
            best = {p, q, square};
        }
    };
    consider(first.nearest(c), c);
    consider(first.nearest(d), d);
    consider(a, second.nearest(a));
    consider(b, second.nearest(b));
    return best;
}

/// The part of the plane that the part of a wall from `a` to `b` can face, at most 60 degrees off its normal.
struct Cone {
    Vec2 a, normal;
    Box2 part;
    bool left = false, right = false; ///< sides on which the domain lies

    /// Returns false if nothing in the box can be faced.
    bool reaches(const Box2 &box) const {
        const Vec2 middle = box.centre() - a, half = 0.5 * box.size();
        const double side = dot(middle, normal);
        const double spread = half.x * std::fabs(normal.x) + half.y * std::fabs(normal.y);
        const double furthest = std::max(left ? side + spread : 0.0, right ? spread - side : 0.0);
        const Vec2 gap{std::max({box.min.x - part.max.x, part.min.x - box.max.x, 0.0}),
                       std::max({box.min.y - part.max.y, part.min.y - box.max.y, 0.0})};
        constexpr double kMargin = 0.99; // for rounding errors
        return furthest > 0.0 && furthest >= kMargin * kFacing * length(gap);
    }
};

/// The part of a segment from `a` to `b`, which may coincide.
struct SegmentPart {
    Vec2 a, b;
    Vec2 direction; ///< of the segment, of unit length
    double length = 0.0;
    double rounding = 0.0; ///< bound on the error of distances

    bool touches(const PlacedSegment &wall) const { return wall.a == a || wall.b == a || wall.a == b || wall.b == b; }
    /// Returns true if a wall that begins at an end of the part, and goes in the direction `back`, runs back along it.
    bool isSharp(const PlacedSegment &wall, Vec2 back) const {
        const double along = dot(wall.a == a || wall.b == a ? direction : -1.0 * direction, back);
        return along > kFacing * forefront::length(back);
    }
    /// Returns true if all of a wall is ahead of the part or behind it, and farther than `within` or too far off the
    /// normal to face it. `side`: its greatest distance from the line through the part.
    bool isBeyond(const PlacedSegment &wall, double side, double within) const {
        const double alongA = dot(wall.a - a, direction), alongB = dot(wall.b - a, direction);
        const double ahead = std::max(std::min(alongA, alongB) - length, -std::max(alongA, alongB)) - rounding;
        return ahead > kSafely * within || ahead > kSafely * kSteepest * side;
    }
};

bool sharesEnd(const DomainSegment &s, const DomainSegment &t) {
    return s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b;
}

BoxTree treeOf(const std::vector<PlacedSegment> &segments) {
    std::vector<Box2> boxes;
    boxes.reserve(segments.size());
    for (const PlacedSegment &segment : segments) {
        boxes.push_back(boxOf(segment.a, segment.b));
    }
    return BoxTree(boxes);
}

} // namespace

SegmentIndex::SegmentIndex(std::vector<PlacedSegment> placed) : segments(std::move(placed)), tree(treeOf(segments)) {}

GapFinder::GapFinder(const Domain &domain, const LazyFaces &faces, const SegmentIndex &index, double longest,
                     double shortest, const Progress &progress, GapRules rules)
    : domain_(domain), faces_(faces), index_(index), places_(chainPlaces(domain, index.segments)),
      crowded_(domain, index.segments), longest_(longest), shortest_(shortest), box_(spacingBox(domain)),
      rounding_(kRounding *
                std::max({std::fabs(box_.min.x), std::fabs(box_.min.y), std::fabs(box_.max.x), std::fabs(box_.max.y)})),
      progress_(progress), rules_(rules) {}

bool GapFinder::isPoint(const PlacedSegment &segment) const {
    return segment.index >= domain_.segments.size();
}

bool GapFinder::isWall(std::uint32_t position) const {
    return domain_.segments[index_.segments[position].index].role == SegmentRole::Boundary;
}

GapFinder::Sides GapFinder::insideOf(std::uint32_t position) const {
    const PlacedSegment &segment = index_.segments[position];
    const Vec2 direction = segment.b - segment.a;
    const Vec2 middle = midpoint(segment.a, segment.b);
    // A ray along the axis that crosses the segment at the larger angle: +x (vertical segment) or +y.
    const bool vertical = std::fabs(direction.y) >= std::fabs(direction.x);
    Box2 ray = boxOf(middle, middle);
    (vertical ? ray.max.x : ray.max.y) = vertical ? box_.max.x : box_.max.y;
    bool odd = false;
    index_.tree.query(ray, [&](std::uint32_t other) {
        const PlacedSegment &wall = index_.segments[other];
        if (other == position || isPoint(wall) || domain_.segments[wall.index].role != SegmentRole::Boundary) {
            return;
        }
        const auto across = [&](Vec2 p) { return vertical ? p.y - middle.y : p.x - middle.x; };
        const auto along = [&](Vec2 p) { return vertical ? p.x - middle.x : p.y - middle.y; };
        const double from = across(wall.a);
        const double to = across(wall.b);
        if ((from > 0.0) != (to > 0.0)) {
            const double t = from / (from - to);
            odd = odd != (along(wall.a) + t * (along(wall.b) - along(wall.a)) > 0.0);
        }
    });
    if (domain_.segments[segment.index].role != SegmentRole::Boundary) {
        return {odd, odd};
    }
    // A ray along +x leaves a downward segment on its left, a ray along +y one that runs to the right.
    const bool leavesLeft = vertical ? direction.y < 0.0 : direction.x > 0.0;
    return leavesLeft ? Sides{odd, !odd} : Sides{!odd, odd};
}

bool GapFinder::openLikeCorner(std::uint32_t position, std::uint32_t other, Vec2 p, Vec2 q) const {
    bool open = false;
    forEachWay(places_[position], index_.segments[position], p, places_[other], index_.segments[other], q,
               [&](const ChainWay &way) {
                   // The base of a triangle with an angle of 60 degrees or more is at least half of the other two sides
                   // together.
                   open = open || (kAlmost * distance(p, q) >= 0.5 * way.length &&
                                   -dot(way.from, way.to) < kAlmost * kFacing * length(way.from) * length(way.to));
               });
    return open;
}

GapFinder::Facing GapFinder::facing(std::uint32_t position, Vec2 a, Vec2 b, double reach, Sides sides,
                                    std::uint32_t likely) const {
    // A reach as large as the domain would visit all of it, so the search begins nearby.
    constexpr double kWider = 4.0;
    for (double near = 2.0 * std::max(length(b - a), shortest_); rules_.everywhere && near < reach; near *= kWider) {
        if (const Facing found = facingWithin(position, a, b, near, sides, likely); found.width != kNothing) {
            return found;
        }
    }
    return facingWithin(position, a, b, reach, sides, likely);
}

GapFinder::Facing GapFinder::facingWithin(std::uint32_t position, Vec2 a, Vec2 b, double reach, Sides sides,
                                          std::uint32_t likely) const {
    const PlacedSegment &own = index_.segments[position];
    const DomainSegment &ends = domain_.segments[own.index];
    const Vec2 normal = (1.0 / own.length()) * leftNormal(own.b - own.a);
    const SizeSite site = SizeSite::segment(a, b, 1.0, 0.0);
    Facing best;
    double within = reach, square = reach * reach;
    const Box2 part = boxOf(a, b);
    Box2 around = part.grown(reach); // shrinks as nearer ones are found
    const SegmentPart piece{a, b, {normal.y, -normal.x}, length(b - a), rounding_};
    const CrowdedNodes::Hidden hidden = crowded_.hiddenFrom(position, a, b);
    const auto visit = [&](std::uint32_t other) {
        if (other == position) {
            return;
        }
        const PlacedSegment &wall = index_.segments[other];
        if (hidden.any() && !isPoint(wall) && hidden.contains(other, wall, domain_.segments[wall.index])) {
            return;
        }
        const double sideA = dot(wall.a - a, normal), sideB = dot(wall.b - a, normal);
        if (!(sides.left && std::max(sideA, sideB) > 0.0) && !(sides.right && std::min(sideA, sideB) < 0.0)) {
            return;
        }
        if (piece.touches(wall)) {
            const Vec2 back = wall.a == a || wall.a == b ? wall.b - wall.a : wall.a - wall.b;
            best.tip = best.tip || (piece.isSharp(wall, back) && (dot(back, normal) > 0.0 ? sides.left : sides.right));
            return;
        }
        if (piece.isBeyond(wall, std::max(std::fabs(sideA), std::fabs(sideB)), within)) {
            return;
        }
        const Pair pair = closest(site, a, b, wall.a, wall.b);
        if (pair.square == 0.0) {
            return; // it touches the part, so there is no domain between them
        }
        if (pair.square >= square) {
            return;
        }
        const double side = dot(pair.q - pair.p, normal);
        if (std::fabs(side) < kFacing * std::sqrt(pair.square) || !(side > 0.0 ? sides.left : sides.right)) {
            return;
        }
        const bool neighbours = !isPoint(wall) && sharesEnd(ends, domain_.segments[wall.index]);
        if (!neighbours && openLikeCorner(position, other, pair.p, pair.q)) {
            return;
        }
        square = pair.square;
        best.wall = other;
        best.width = within = std::sqrt(square);
        around = part.grown(within + rounding_);
        best.corner = neighbours;
        best.needle = false;
        if (neighbours) {
            const DomainSegment &far = domain_.segments[wall.index];
            const bool atA = far.a == ends.a || far.b == ends.a;
            const Vec2 along = atA ? own.b - own.a : own.a - own.b;
            const Vec2 back = far.a == (atA ? ends.a : ends.b) ? wall.b - wall.a : wall.a - wall.b;
            best.needle = dot(along, back) > kNeedle * length(along) * length(back);
            best.opening = distance((1.0 / length(along)) * along, (1.0 / length(back)) * back);
        }
    };
    if (likely != kNoIndex) { // only narrows the search, in which it may be found again
        visit(likely);
        square = best.wall == kNoIndex ? square : std::nextafter(square, kNothing);
        best = {};
    }
    const auto visitOn = [&](std::uint32_t other) {
        visit(other);
        return true;
    };
    if (rules_.everywhere) {
        const Cone cone{a, normal, part, sides.left, sides.right};
        index_.tree.search([&](const Box2 &box) { return box.overlaps(around) && cone.reaches(box); }, visitOn);
    } else {
        index_.tree.search(around, visitOn);
    }
    return best;
}

void GapFinder::divide(std::uint32_t position, double from, double to, double reach, Sides sides, Found &found) const {
    if (progress_.cancelled()) {
        return;
    }
    const PlacedSegment &own = index_.segments[position];
    const Vec2 a = lerp(own.a, own.b, from);
    const Vec2 b = to == 1.0 ? own.b : lerp(own.a, own.b, to); // exactly the end, where neighbours touch it
    const Facing nearest = facing(position, a, b, rules_.across * reach, sides, found.wall);
    found.wall = nearest.wall;
    // Near a sharp corner the width falls to zero with the distance to it, so it is followed only down to a floor.
    const double floor = nearest.tip || nearest.corner ? std::max(shortest_, kCornerFloor * reach) : shortest_;
    const bool wide = nearest.width == kNothing;
    if (length(b - a) > 2.0 * floor && (nearest.tip || !wide)) {
        const auto varies = [&] {
            // Widths beyond twice the narrowest are all the same here.
            const double farthest = std::min(rules_.across * reach, 2.0 * nearest.width + rounding_);
            const auto widthAt = [&](Vec2 p) { return facing(position, p, p, farthest, sides, nearest.wall).width; };
            const double same = own.besideCurve ? kSameWidthAtCurve : kSameWidth;
            const double atA = widthAt(a);
            if (atA > same * nearest.width && length(b - a) > nearest.width) {
                return true; // for any width at the other end
            }
            const double atB = widthAt(b);
            const double narrowest = std::min(nearest.width, std::min(atA, atB));
            if (!(length(b - a) > narrowest)) {
                return false;
            }
            // A side between two rounded corners is narrow at both ends alone.
            const double limit = same * narrowest;
            return std::max(atA, atB) > limit || (own.besideCurve && widthAt(midpoint(a, b)) > limit);
        };
        if (nearest.tip || varies()) {
            const double middle = 0.5 * (from + to);
            divide(position, from, middle, reach, sides, found);
            divide(position, middle, to, reach, sides, found);
            return;
        }
    }
    const bool blunt = nearest.corner && !nearest.needle;
    const bool negligible = nearest.width < kNegligibleGap * reach;
    const bool hopeless = rules_.everywhere
                              ? blunt || nearest.width < (nearest.needle ? kCornerFloor * reach : shortest_)
                              : negligible && (nearest.needle || (!blunt && length(b - a) > kLongGap * nearest.width));
    if (!wide && !hopeless) {
        const double minimum = blunt ? kSteepest * nearest.opening * reach : 0.0;
        found.gaps.push_back({a, b, own.wholeLength, std::max(nearest.width, minimum), own.index, nearest.corner});
    }
}

double GapFinder::reachOf(const PlacedSegment &segment) const {
    return rules_.everywhere ? longest_ : std::min(longest_, segment.wholeLength);
}

/// Finds, for each node, the segments there along which the sides stay the same: those of a boundary that passes
/// through the node, or lines that no boundary touches there.
struct GapFinder::Continuations {
    Rows<std::uint32_t> positions; ///< per node: of segments in the index
};

GapFinder::Continuations GapFinder::findContinuations() const {
    const auto forEnds = [&](const auto &visit) {
        for (std::uint32_t i = 0; i < index_.segments.size(); ++i) {
            if (!isPoint(index_.segments[i])) {
                const DomainSegment &ends = domain_.segments[index_.segments[i].index];
                visit(i, ends.a);
                visit(i, ends.b);
            }
        }
    };
    std::vector<std::uint32_t> walls(domain_.nodes.size(), 0); // per node: number of boundary segments
    forEnds([&](std::uint32_t i, std::uint32_t node) { walls[node] += isWall(i) ? 1U : 0U; });
    const auto continues = [&](std::uint32_t i, std::uint32_t node) { return walls[node] == (isWall(i) ? 2U : 0U); };
    return {Rows<std::uint32_t>(domain_.nodes.size(), [&](const auto &add) {
        forEnds([&](std::uint32_t i, std::uint32_t node) {
            if (continues(i, node)) {
                add(node, i);
            }
        });
    })};
}

/// Returns the segments that continue one another, from the first on, and records the direction of each along them.
std::vector<std::uint32_t> GapFinder::chainFrom(std::uint32_t first, const Continuations &continuations,
                                                std::vector<Direction> &directions) const {
    std::vector<std::uint32_t> chain{first};
    directions[first] = Direction::Along;
    for (std::size_t k = 0; k < chain.size(); ++k) {
        const DomainSegment &here = domain_.segments[index_.segments[chain[k]].index];
        const bool along = directions[chain[k]] == Direction::Along;
        for (const std::uint32_t node : {here.a, here.b}) {
            for (const std::uint32_t other : continuations.positions[node]) {
                if (directions[other] != Direction::Unknown || isWall(other) != isWall(first)) {
                    continue;
                }
                const DomainSegment &there = domain_.segments[index_.segments[other].index];
                const bool same = (there.a == node) != (here.a == node);
                directions[other] = same == along ? Direction::Along : Direction::Against;
                chain.push_back(other);
            }
        }
    }
    return chain;
}

std::vector<GapFinder::Sides> GapFinder::sidesByFaces(const DomainFaces &found) const {
    std::vector<std::uint32_t> edgeOf(domain_.segments.size(), kNoIndex);
    for (std::uint32_t e = 0; e < found.graph.segment.size(); ++e) {
        edgeOf[found.graph.segment[e]] = e;
    }
    std::vector<Sides> sides(index_.segments.size());
    for (std::uint32_t i = 0; i < index_.segments.size(); ++i) {
        if (const std::uint32_t e = isPoint(index_.segments[i]) ? kNoIndex : edgeOf[index_.segments[i].index];
            e != kNoIndex) {
            sides[i] = {found.labels.inside[found.faces.left[e]] != 0, found.labels.inside[found.faces.right[e]] != 0};
        }
    }
    return sides;
}

/// Decides for every segment on which sides of it the domain lies.
std::vector<GapFinder::Sides> GapFinder::findSides() const {
    const DomainFaces *const found = domain_.insideRule == InsideRule::HoleMarkers ? faces_.get() : nullptr;
    return found != nullptr ? sidesByFaces(*found) : sidesByCounting();
}

/// Counts the walls that one ray for each chain, from its longest segment, crosses.
std::vector<GapFinder::Sides> GapFinder::sidesByCounting() const {
    const Continuations continuations = findContinuations();
    std::vector<Direction> directions(index_.segments.size(), Direction::Unknown);
    std::vector<Sides> sides(index_.segments.size());
    for (std::uint32_t first = 0; first < index_.segments.size() && !progress_.cancelled(); ++first) {
        if (isPoint(index_.segments[first]) || directions[first] != Direction::Unknown) {
            continue;
        }
        const std::vector<std::uint32_t> chain = chainFrom(first, continuations, directions);
        const std::uint32_t longest =
            *std::max_element(chain.begin(), chain.end(), [&](std::uint32_t i, std::uint32_t j) {
                return index_.segments[i].length() < index_.segments[j].length();
            });
        const Sides found = insideOf(longest), turned{found.right, found.left};
        for (const std::uint32_t i : chain) {
            sides[i] = directions[i] == directions[longest] ? found : turned;
        }
    }
    return sides;
}

std::vector<Gap> GapFinder::find() const {
    const std::vector<Sides> sides = findSides();
    Found found;
    for (std::uint32_t i = 0; i < index_.segments.size() && !progress_.cancelled(); ++i) {
        const PlacedSegment &segment = index_.segments[i];
        if (!isPoint(segment) && (sides[i].left || sides[i].right)) {
            divide(i, 0.0, 1.0, reachOf(segment), sides[i], found);
        }
    }
    return std::move(found.gaps);
}

double GapFinder::clearance(std::uint32_t position) const {
    const Vec2 p = index_.segments[position].a;
    // Search in growing boxes, which is cheap where points are crowded.
    double nearest = longest_;
    for (double reach = longest_ / 256.0; reach <= longest_ && nearest > reach / 2.0; reach *= 2.0) {
        index_.tree.query(boxAround(p, reach), [&](std::uint32_t other) {
            if (other != position) {
                const double d = distance(p, nearestOn(index_.segments[other].a, index_.segments[other].b, p));
                nearest = d > 0.0 ? std::min(nearest, d) : nearest;
            }
        });
    }
    return nearest;
}

} // namespace forefront
