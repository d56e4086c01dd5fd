#include "core/engine/boundary/misplaced_nodes.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/geometry/predicates.hpp"

#include <algorithm>
#include <span>

namespace forefront {

namespace {

/// A segment seen from one of its ends.
struct Ray {
    std::uint32_t to = 0;
    std::uint32_t left = kOutside;
    std::uint32_t right = kOutside;
};

/// The segments at every node, in rows.
class NodeRays {
  public:
    explicit NodeRays(const DiscreteDomain &domain) : starts_(domain.nodes.size() + 1, 0) {
        for (const DiscreteSegment &segment : domain.segments) {
            ++starts_[segment.a];
            ++starts_[segment.b];
        }
        std::uint32_t sum = 0;
        for (std::uint32_t &start : starts_) {
            sum += start;
            start = sum;
        }
        rays_.resize(sum);
        for (const DiscreteSegment &segment : domain.segments) {
            rays_[--starts_[segment.a]] = {segment.b, segment.leftRegion, segment.rightRegion};
            rays_[--starts_[segment.b]] = {segment.a, segment.rightRegion, segment.leftRegion};
        }
    }
    std::span<Ray> at(std::uint32_t node) { return {rays_.data() + starts_[node], starts_[node + 1] - starts_[node]}; }

  private:
    std::vector<std::uint32_t> starts_;
    std::vector<Ray> rays_;
};

/// Sorts the rays counter-clockwise, from straight down (excluded) on.
void sortAround(const DiscreteDomain &domain, std::uint32_t node, std::span<Ray> rays) {
    const Vec2 centre = domain.nodes[node];
    std::sort(rays.begin(), rays.end(), [&](const Ray &m, const Ray &n) {
        const Vec2 p = domain.nodes[m.to], q = domain.nodes[n.to];
        const bool pRight = comesBefore(centre, p), qRight = comesBefore(centre, q);
        return pRight != qRight ? pRight : orientation(centre, p, q) > 0;
    });
}

} // namespace

std::uint32_t regionAbove(const DiscreteDomain &domain, std::uint32_t edge) {
    if (edge == kNoIndex) {
        return kOutside;
    }
    const DiscreteSegment &piece = domain.segments[edge];
    return comesBefore(domain.nodes[piece.a], domain.nodes[piece.b]) ? piece.leftRegion : piece.rightRegion;
}

std::vector<std::uint32_t> misplacedNodes(const DiscreteDomain &domain, const PlaneSweepResult &sweep) {
    std::vector<std::uint32_t> misplaced;
    NodeRays all(domain);
    for (std::uint32_t node = 0; node < domain.nodes.size(); ++node) {
        const std::span<Ray> rays = all.at(node);
        if (rays.empty()) {
            continue;
        }
        sortAround(domain, node, rays);
        bool fits = true;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            fits = fits && rays[i].left == rays[i + 1 == rays.size() ? 0 : i + 1].right;
        }
        const bool leftmost = comesBefore(domain.nodes[node], domain.nodes[rays.back().to]);
        if (!fits || (leftmost && rays.front().right != regionAbove(domain, sweep.below[node]))) {
            misplaced.push_back(node);
        }
    }
    return misplaced;
}

} // namespace forefront
