#include "core/engine/layers/layer_rays.hpp"

#include "core/engine/geometry/predicates.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace forefront {

namespace {

constexpr double kFanFrom = std::numbers::pi / 3.0;    ///< turn of a convex corner, in radians
constexpr double kFanStep = std::numbers::pi / 9.0;    ///< greatest angle between rays of a fan
constexpr double kCornerFrom = std::numbers::pi / 9.0; ///< turn beside which rays lean over
constexpr double kMaxStretch = 2.0;                    ///< of a ray at a concave corner, reached at 60 degrees
/// Rays lean over within this many times the height of the layers, times the tangent of the lean if that is above 1:
/// the tops of the columns there are at most a third narrower or wider than their wall edges.
constexpr double kLeanReach = 3.0;
/// Lean of the layers' top at a corner, in lengths of the edge beside it, that needs no help from the rays beside it.
constexpr double kSmallLean = 0.3;
constexpr double kMinSlide = std::numbers::sqrt2 / 2.0; ///< sine of the angle between a wall and its neighbour

/// A node of a chain, with the wall edges before and after it; at an end of the chain both are the same edge.
struct WallNode {
    std::uint32_t node = 0;
    std::uint32_t before = 0, after = 0; ///< indices of edges of the chain
    double turn = 0.0;                   ///< in radians; positive where the layers are on the inside of the bend
    Vec2 normal;                         ///< unit normal, of a corner its bisector
    double stretch = 1.0;
    double lean = 0.0; ///< of its ray, in heights along the wall
    bool isFan() const { return turn < -kFanFrom; }
    bool isCorner() const { return std::abs(turn) > kCornerFrom; }
};

class RayMaker {
  public:
    RayMaker(const DiscreteDomain &boundary, const WallChain &chain, std::span<const LayerHeights> heights,
             std::span<const LayerSpec> specs)
        : boundary_(boundary), chain_(chain), heights_(heights), specs_(specs) {
        for (const WallEdge &edge : chain.edges) {
            const Vec2 along = boundary.nodes[edge.b] - boundary.nodes[edge.a];
            lengths_.push_back(length(along));
            along_.push_back((1.0 / lengths_.back()) * along);
        }
        const auto count = static_cast<std::uint32_t>(chain.edges.size());
        for (std::uint32_t i = 0; i < count + (chain.closed ? 0U : 1U); ++i) {
            const std::uint32_t before = i > 0 ? i - 1 : chain.closed ? count - 1 : 0;
            addNode(before, i < count ? i : count - 1, i < count ? chain.edges[i].a : chain.edges.back().b);
        }
    }

    RayChain make(const SlidingRules &sliding) {
        RayChain result;
        result.closed = chain_.closed;
        if (!chain_.closed) {
            result.ends = {LayerEnd{chain_.before, kNoIndex}, LayerEnd{chain_.after, kNoIndex}};
            slide(result.ends[0], 0, sliding);
            slide(result.ends[1], nodes_.size() - 1, sliding);
        }
        leanBesideCorners();
        addRays(result);
        return result;
    }

  private:
    bool isEnd(std::size_t i) const { return !chain_.closed && (i == 0 || i + 1 == nodes_.size()); }

    void addNode(std::uint32_t before, std::uint32_t after, std::uint32_t node) {
        WallNode here;
        here.node = node;
        here.before = before;
        here.after = after;
        const Vec2 a = along_[before], b = along_[after];
        here.normal = leftNormal(b);
        if (before != after || chain_.closed) {
            const Vec2 from = boundary_.nodes[chain_.edges[before].a], at = boundary_.nodes[node],
                       to = boundary_.nodes[chain_.edges[after].b];
            const int side = orientation(from, at, to);
            const double angle = std::atan2(std::abs(cross(a, b)), dot(a, b));
            // Edges along the same line that turn back enclose the end of a wall inside the domain.
            here.turn = side > 0 ? angle : side < 0 || dot(a, b) < 0.0 ? -angle : 0.0;
            if (!here.isFan()) {
                const Vec2 sum = leftNormal(a) + leftNormal(b);
                const double size = length(sum);
                here.normal = size > 1e-9 ? (1.0 / size) * sum : -1.0 * a; // a cleft: back along both edges
                here.stretch = std::min(kMaxStretch, 1.0 / std::max(dot(here.normal, leftNormal(a)), 1e-9));
            }
        }
        nodes_.push_back(here);
    }

    const LayerHeights &heightsAt(const WallNode &node) const { return heights_[specAt(node)]; }
    /// Returns the specification with the lower first layer, where two meet.
    std::uint32_t specAt(const WallNode &node) const {
        const std::uint32_t a = chain_.edges[node.before].spec, b = chain_.edges[node.after].spec;
        return specs_[b].first < specs_[a].first ? b : a;
    }
    double meanLength(const WallNode &node) const { return 0.5 * (lengths_[node.before] + lengths_[node.after]); }
    double thickness(const WallNode &node) const {
        const LayerHeights &heights = heightsAt(node);
        return heights[heights.countOver(meanLength(node))];
    }

    /// Lets the ray at an end slide along the neighbour if that is straight and neither too steep nor too flat.
    void slide(LayerEnd &end, std::size_t i, const SlidingRules &rules) {
        const DiscreteSegment &segment = boundary_.segments[end.neighbour.segment];
        const DomainSegment &source = rules.domain->segments[segment.source];
        const bool inner = segment.leftRegion != kOutside && segment.rightRegion != kOutside;
        if (rules.keepBoundary || rules.elements[segment.source] > 0 || source.stretch.follows() || inner) {
            return;
        }
        const WallNode &node = nodes_[i];
        const Vec2 there = boundary_.nodes[end.neighbour.far] - boundary_.nodes[node.node];
        const double sine = dot(there, node.normal) / length(there);
        if (sine >= kMinSlide) {
            end.slidesAlong = segment.source;
            nodes_[i].lean = dot(there, along_[node.before]) / dot(there, node.normal);
        }
    }

    void leanBesideCorners() {
        std::vector<double> lean(nodes_.size(), 0.0);
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const WallNode &node = nodes_[i];
            if (isEnd(i)) {
                spread(i, node.lean, i == 0, lean);
            } else if (node.isCorner() && !node.isFan()) {
                const double own = std::copysign(
                    std::min(std::tan(0.5 * std::abs(node.turn)), std::sqrt(kMaxStretch * kMaxStretch - 1.0)),
                    node.turn);
                spread(i, own, true, lean);
                spread(i, -own, false, lean);
            }
        }
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            if (!isEnd(i) && !nodes_[i].isCorner()) {
                nodes_[i].lean = lean[i];
            }
        }
    }

    /// Adds to the leans of the nodes after or before a corner, as far as the next corner.
    void spread(std::size_t corner, double own, bool forward, std::vector<double> &lean) const {
        const WallNode &node = nodes_[corner];
        const double high = thickness(node);
        if (high * std::abs(own) <= kSmallLean * lengths_[forward ? node.after : node.before]) {
            return;
        }
        const double reach = kLeanReach * high * std::max(1.0, std::abs(own));
        double from = 0.0;
        for (std::size_t i = corner;;) {
            from += lengths_[forward ? nodes_[i].after : nodes_[i].before];
            i = forward ? (i + 1 == nodes_.size() ? 0 : i + 1) : (i == 0 ? nodes_.size() - 1 : i - 1);
            if (from >= reach || isEnd(i) || nodes_[i].isCorner()) {
                return;
            }
            lean[i] += own * (1.0 - from / reach);
        }
    }

    void addRays(RayChain &result) const {
        std::uint32_t fans = 0;
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const WallNode &node = nodes_[i];
            LayerRay ray;
            ray.base = boundary_.nodes[node.node];
            ray.node = node.node;
            ray.spec = specAt(node);
            ray.asked = ray.count = heightsAt(node).countOver(meanLength(node));
            if (node.isFan()) {
                ray.fan = fans++;
                addFan(node, ray, result);
            } else {
                const Vec2 along{node.normal.y, -node.normal.x};
                ray.direction = node.stretch * node.normal + node.lean * along;
                result.rays.push_back(ray);
            }
            if (chain_.closed || i + 1 < nodes_.size()) {
                result.columns.push_back(chain_.edges[node.after]);
            }
        }
    }

    void addFan(const WallNode &node, LayerRay ray, RayChain &result) const {
        const auto sectors = static_cast<int>(std::ceil(-node.turn / kFanStep - 1e-9));
        const Vec2 normal = leftNormal(along_[node.before]), along = along_[node.before];
        for (int j = 0; j <= sectors; ++j) {
            const double angle = -node.turn * j / sectors; // clockwise
            ray.direction =
                j < sectors ? std::cos(angle) * normal + std::sin(angle) * along : leftNormal(along_[node.after]);
            result.rays.push_back(ray);
            if (j < sectors) {
                WallEdge sector = chain_.edges[node.after];
                sector.b = sector.a;
                result.columns.push_back(sector);
            }
        }
    }

    const DiscreteDomain &boundary_;
    const WallChain &chain_;
    std::span<const LayerHeights> heights_;
    std::span<const LayerSpec> specs_;
    std::vector<double> lengths_; ///< of the wall edges
    std::vector<Vec2> along_;     ///< their unit vectors
    std::vector<WallNode> nodes_;
};

} // namespace

RayChain raysOf(const DiscreteDomain &boundary, const WallChain &chain, std::span<const LayerHeights> heights,
                std::span<const LayerSpec> specs, const SlidingRules &sliding) {
    return RayMaker(boundary, chain, heights, specs).make(sliding);
}

} // namespace forefront
