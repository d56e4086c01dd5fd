#include "core/engine/layers/layer_limits.hpp"

#include "core/engine/geometry/box_tree.hpp"
#include "core/engine/geometry/predicates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace forefront {

namespace {

constexpr double kShareOfWalls = 0.42; ///< of the distance between two walls with layers
constexpr double kShareOfOthers = 0.6; ///< of the distance to a part without layers
/// A part faces a ray if the cosine of the angle between its normal and the ray is less than this: walls that are at
/// right angles, too, unless the ray leans away; other parts only if the ray approaches them.
constexpr double kWallFaces = 0.3;
constexpr double kOtherFaces = -0.1;
constexpr double kShareOfEnd = 0.8; ///< of a neighbour that layers slide along from one end

/// The free distance that a ray needs beyond its end, as a multiple of its length.
constexpr double needed(double share) {
    return 1.0 / share - 1.0;
}

double distanceTo(Vec2 a, Vec2 b, Vec2 p) {
    const Vec2 ab = b - a;
    const double square = lengthSquared(ab);
    const double t = square > 0.0 ? std::clamp(dot(p - a, ab) / square, 0.0, 1.0) : 0.0;
    return distance(p, a + t * ab);
}

class Obstacles {
  public:
    Obstacles(const DiscreteDomain &boundary, std::span<const LayerHeights> heights, std::span<const LayerSpec> specs)
        : boundary_(boundary), heights_(heights) {
        std::set<std::int32_t> tags;
        for (const LayerSpec &spec : specs) {
            tags.insert(spec.tag);
        }
        std::vector<Box2> boxes;
        for (const DiscreteSegment &s : boundary.segments) {
            boxes.push_back(boxOf(boundary.nodes[s.a], boundary.nodes[s.b]));
            layered_.push_back(tags.contains(s.tag) ? 1 : 0);
        }
        for (const ConstraintPoint &point : boundary.taggedPoints()) { // others give way to layers
            boxes.push_back(boxOf(boundary.nodes[point.node], boundary.nodes[point.node]));
        }
        tree_ = BoxTree(boxes);
    }

    /// `sliding`: segments of the domain that the ends of its chain slide along, which do not stop it.
    void limit(LayerRay &ray, const std::array<std::uint32_t, 2> &sliding) const {
        const double reach = lengthAt(ray, ray.count) * needed(kShareOfWalls);
        const Box2 around = boxOf(ray.base, placeOn(ray, ray.count, heights_)).grown(reach);
        std::vector<std::uint32_t> near;
        tree_.query(around, [&](std::uint32_t item) { near.push_back(item); });
        std::sort(near.begin(), near.end()); // of equal limits the first obstacle is reported
        for (const std::uint32_t item : near) {
            if (item < boundary_.segments.size()) {
                limitBy(item, ray, sliding);
            } else {
                const ConstraintPoint &point = boundary_.points[item - boundary_.segments.size()];
                if (point.node != ray.node) {
                    const Vec2 at = boundary_.nodes[point.node];
                    limitTo(ray, at, at, needed(kShareOfOthers), LayerStop::Point, point.tag);
                }
            }
        }
    }

  private:
    double lengthAt(const LayerRay &ray, std::uint32_t k) const {
        return heights_[ray.spec][k] * length(ray.direction);
    }

    void limitBy(std::uint32_t number, LayerRay &ray, const std::array<std::uint32_t, 2> &sliding) const {
        const DiscreteSegment &s = boundary_.segments[number];
        if (s.a == ray.node || s.b == ray.node || s.source == sliding[0] || s.source == sliding[1]) {
            return;
        }
        const Vec2 a = boundary_.nodes[s.a], b = boundary_.nodes[s.b];
        const bool wall = layered_[number] != 0;
        if (faces(s, a, b, wall, ray) ||
            meet(ray.base, placeOn(ray, ray.count, heights_), a, b) != SegmentMeeting::Apart) {
            limitTo(ray, a, b, needed(wall ? kShareOfWalls : kShareOfOthers), LayerStop::Wall, s.tag);
        }
    }

    /// Returns true if the ray starts on a side of the segment inside the domain and runs towards it.
    bool faces(const DiscreteSegment &s, Vec2 a, Vec2 b, bool wall, const LayerRay &ray) const {
        const Vec2 normal = leftNormal(b - a);
        const double side = dot(ray.base - a, normal);
        const double inLine = 1e-9 * length(normal) * length(ray.base - a); // around a convex corner
        if (std::max(dot(a - ray.base, ray.direction), dot(b - ray.base, ray.direction)) <= 0.0) {
            return false; // behind it, as the sides of a trailing edge
        }
        const double approach = dot(normal, ray.direction) / (length(normal) * length(ray.direction));
        const double limit = wall ? kWallFaces : kOtherFaces;
        return (s.leftRegion != kOutside && side > inLine && approach < limit) ||
               (s.rightRegion != kOutside && side < -inLine && -approach < limit);
    }

    /// Lowers the ray to its last layer before the first that has too little free distance to ab.
    void limitTo(LayerRay &ray, Vec2 a, Vec2 b, double need, LayerStop why, std::int32_t tag) const {
        for (std::uint32_t k = 1; k <= ray.count; ++k) {
            if (need * lengthAt(ray, k) > distanceTo(a, b, placeOn(ray, k, heights_))) {
                ray.lower(k - 1, why, tag);
            }
        }
    }

    const DiscreteDomain &boundary_;
    std::span<const LayerHeights> heights_;
    std::vector<std::uint8_t> layered_; ///< per segment
    BoxTree tree_;                      ///< over the segments, then the points
};

/// Lowers the rays from `from` on in one direction until they are level.
void levelOneWay(RayChain &chain, bool forward) {
    const std::size_t columns = chain.columns.size(), rounds = chain.closed ? 2 : 1;
    for (std::size_t i = 0; i < rounds * columns; ++i) {
        const std::size_t column = forward ? i % columns : columns - 1 - i % columns;
        LayerRay &first = chain.rays[column], &second = chain.rayAfter(column);
        const LayerRay &low = forward ? first : second;
        LayerRay &high = forward ? second : first;
        high.lower(low.count + (RayChain::isFan(chain.columns[column]) ? 0U : 1U), low.stop, low.stoppedBy);
    }
}

} // namespace

bool limitByObstacles(const DiscreteDomain &boundary, std::span<const LayerHeights> heights,
                      std::span<const LayerSpec> specs, std::vector<RayChain> &chains, const Progress &progress) {
    constexpr std::size_t kBatch = 64; // rays between checks for cancellation
    const Obstacles obstacles(boundary, heights, specs);
    std::size_t done = 0;
    for (RayChain &chain : chains) {
        for (LayerRay &ray : chain.rays) {
            if (done++ % kBatch == 0 && progress.cancelled()) {
                return false;
            }
            obstacles.limit(ray, {chain.ends[0].slidesAlong, chain.ends[1].slidesAlong});
        }
    }
    return true;
}

void limitAtEnds(const Domain &domain, const DiscreteDomain &boundary, std::span<const LayerHeights> heights,
                 std::vector<RayChain> &chains) {
    std::map<std::uint32_t, unsigned> slides; // number of rays along each segment of the domain
    for (const RayChain &chain : chains) {
        for (const LayerEnd &end : chain.ends) {
            slides[end.slidesAlong] += 1;
        }
    }
    for (RayChain &chain : chains) {
        for (std::size_t e = 0; !chain.closed && e < 2; ++e) {
            LayerEnd &end = chain.ends[e];
            LayerRay &ray = e == 0 ? chain.rays.front() : chain.rays.back();
            const std::int32_t tag = boundary.segments[end.neighbour.segment].tag;
            if (end.slidesAlong == kNoIndex) {
                ray.lower(0, LayerStop::End, tag);
                continue;
            }
            const DomainSegment &along = domain.segments[end.slidesAlong];
            const double whole = distance(domain.nodes[along.a], domain.nodes[along.b]);
            const double share = slides[end.slidesAlong] > 1 ? kShareOfWalls : kShareOfEnd;
            while (ray.count > 0 && distance(ray.base, placeOn(ray, ray.count, heights)) > share * whole) {
                ray.lower(ray.count - 1, LayerStop::End, tag);
            }
        }
    }
}

void levelLayers(RayChain &chain) {
    levelOneWay(chain, true);
    levelOneWay(chain, false);
}

} // namespace forefront
