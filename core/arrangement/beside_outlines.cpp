#include "core/arrangement/beside_outlines.hpp"

#include "core/base/ids.hpp"
#include "core/geometry/box_tree.hpp"
#include "core/geometry/polygon.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace forefront {

namespace {

/// Measures how far segments are from outlines.
class OutlineDistance {
  public:
    OutlineDistance(std::span<const Vec2> nodes, std::span<const PlaneEdge> edges, std::span<const BesideRole> roles) {
        std::vector<Box2> boxes;
        for (std::size_t e = 0; e < edges.size(); ++e) {
            if (roles[e] == BesideRole::Outline) {
                outlines_.push_back({nodes[edges[e].a], nodes[edges[e].b]});
                boxes.push_back(boxOf(outlines_.back()[0], outlines_.back()[1]));
            }
        }
        tree_ = BoxTree(boxes);
    }

    /// Returns the maximum distance of the segment's points from the nearest outline; std::nullopt if it is greater
    /// than `reach`.
    std::optional<double> along(Vec2 p, Vec2 q, double reach) const {
        if (distance(p, q) > reach && !isNear(q, reach)) {
            return std::nullopt;
        }
        bool near = false;
        double farthest = std::numeric_limits<double>::infinity(); // from the outline that is the nearest to both ends
        tree_.query(boxAround(p, reach), [&](std::uint32_t outline) {
            const auto &[a, b] = outlines_[outline];
            if (const double fromP = distanceToSegment(a, b, p); fromP <= reach) {
                near = true;
                farthest = std::min(farthest, std::max(fromP, distanceToSegment(a, b, q)));
            }
        });
        if (farthest <= reach) {
            return farthest; // the distance from a segment is a convex function: it is greatest at an end
        }
        if (!near || distance(p, q) < kShortest * reach) {
            return std::nullopt;
        }
        const Vec2 middle = midpoint(p, q);
        const auto first = along(p, middle, reach);
        const auto second = first ? along(middle, q, reach) : std::nullopt;
        return second ? std::optional(std::max(*first, *second)) : std::nullopt;
    }

  private:
    /// Of the reach; shorter parts that no single outline accompanies are too far away.
    static constexpr double kShortest = 1.0 / 16.0;

    bool isNear(Vec2 p, double reach) const {
        return !tree_.search(boxAround(p, reach), [&](std::uint32_t outline) {
            return distanceToSegment(outlines_[outline][0], outlines_[outline][1], p) > reach;
        });
    }

    std::vector<std::array<Vec2, 2>> outlines_;
    BoxTree tree_;
};

/// The loose lines at the nodes.
class LooseChains {
  public:
    LooseChains(std::span<const PlaneEdge> edges, std::span<const BesideRole> roles, std::size_t nodeCount)
        : edges_(edges), around_(nodeCount), taken_(edges.size(), 0) {
        for (std::uint32_t e = 0; e < edges.size(); ++e) {
            if (roles[e] == BesideRole::Dropped) {
                continue;
            }
            for (const std::uint32_t node : {edges[e].a, edges[e].b}) {
                Around &around = around_[node];
                if (around.count < 2 && roles[e] == BesideRole::LooseLine) {
                    around.loose[around.count] = e;
                }
                ++around.count;
            }
        }
    }

    bool taken(std::uint32_t edge) const { return taken_[edge] != 0; }

    /// Returns the edges of the chain through an edge that no chain before it has taken.
    std::vector<std::uint32_t> take(std::uint32_t edge) {
        std::vector<std::uint32_t> chain{edge};
        taken_[edge] = 1;
        for (std::uint32_t node : {edges_[edge].a, edges_[edge].b}) {
            std::uint32_t last = edge;
            for (std::uint32_t next = beyond(last, node); next != kNoIndex && !taken(next); next = beyond(last, node)) {
                taken_[next] = 1;
                chain.push_back(next);
                node = edges_[next].a == node ? edges_[next].b : edges_[next].a;
                last = next;
            }
        }
        return chain;
    }

  private:
    struct Around {
        std::uint32_t count = 0; ///< edges of all roles
        std::array<std::uint32_t, 2> loose{kNoIndex, kNoIndex};
    };

    /// Returns the loose line that continues another one at a node; kNoIndex if none does, or anything else meets them.
    std::uint32_t beyond(std::uint32_t edge, std::uint32_t node) const {
        const Around &around = around_[node];
        return around.count != 2 ? kNoIndex : around.loose[around.loose[0] == edge ? 1 : 0];
    }

    std::span<const PlaneEdge> edges_;
    std::vector<Around> around_;
    std::vector<std::uint8_t> taken_;
};

} // namespace

std::vector<BesideEdge> edgesBesideOutlines(std::span<const Vec2> nodes, std::span<const PlaneEdge> edges,
                                            std::span<const BesideRole> roles, std::span<const double> reach) {
    const OutlineDistance outlines(nodes, edges, roles);
    LooseChains chains(edges, roles, nodes.size());
    std::vector<BesideEdge> found;
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
        if (roles[e] != BesideRole::LooseLine || chains.taken(e)) {
            continue;
        }
        std::vector<BesideEdge> chain;
        for (const std::uint32_t edge : chains.take(e)) {
            const auto distance = outlines.along(nodes[edges[edge].a], nodes[edges[edge].b], reach[edge]);
            if (!distance) {
                chain.clear();
                break;
            }
            chain.push_back({edge, *distance});
        }
        found.insert(found.end(), chain.begin(), chain.end());
    }
    return found;
}

} // namespace forefront
