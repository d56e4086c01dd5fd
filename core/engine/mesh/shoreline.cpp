#include "core/engine/mesh/shoreline.hpp"

#include "core/engine/base/key_order.hpp"
#include "core/engine/mesh/edge_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace forefront {

namespace {

constexpr std::size_t kLand = static_cast<std::size_t>(-1);

/// A side of an element without a neighbour, with the element on its left.
struct ShoreSide {
    NodeId a, b;
    std::size_t part = kLand; ///< index of its tag in the open ones
};

class Shore {
  public:
    Shore(const MeshView &mesh, std::span<const std::int32_t> openTags) : mesh_(mesh) {
        std::vector<std::pair<std::uint64_t, std::size_t>> open; // sides of open parts
        for (const TaggedEdge &edge : mesh.edges) {
            const auto found = std::find(openTags.begin(), openTags.end(), edge.tag);
            if (found != openTags.end()) {
                open.emplace_back(pairKey(std::min(edge.a, edge.b), std::max(edge.a, edge.b)),
                                  static_cast<std::size_t>(found - openTags.begin()));
            }
        }
        std::sort(open.begin(), open.end());
        const EdgeTable table(mesh);
        table.forEach([&](NodeId low, NodeId high, std::span<const HalfEdge> sides) {
            if (sides.size() == 1) {
                const HalfEdges &halves = table.halfEdges();
                const auto at =
                    std::lower_bound(open.begin(), open.end(), std::pair(pairKey(low, high), std::size_t{0}));
                const bool isOpen = at != open.end() && at->first == pairKey(low, high);
                sides_.push_back(
                    {halves.startOf(sides.front()), halves.endOf(sides.front()), isOpen ? at->second : kLand});
            }
        });
        std::sort(sides_.begin(), sides_.end(),
                  [](const ShoreSide &x, const ShoreSide &y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); });
        used_.assign(sides_.size(), 0);
    }

    std::vector<ShoreStretch> stretches() {
        std::vector<std::pair<std::size_t, ShoreStretch>> found; // with their place in the order
        for (std::size_t k = 0; k < sides_.size(); ++k) {
            if (used_[k] == 0) {
                divide(loopFrom(k), found);
            }
        }
        std::stable_sort(found.begin(), found.end(), [](const auto &x, const auto &y) { return x.first < y.first; });
        std::vector<ShoreStretch> result;
        for (auto &[order, stretch] : found) {
            result.push_back(std::move(stretch));
        }
        return result;
    }

  private:
    Vec2 at(NodeId node) const { return mesh_.nodes[index(node)]; }

    /// Returns the side that follows: at a node where several loops meet, the one beyond the water of this side, first
    /// in clockwise direction from the way back.
    std::size_t next(const ShoreSide &side) const {
        const auto first = std::lower_bound(sides_.begin(), sides_.end(), side.b,
                                            [](const ShoreSide &each, NodeId node) { return each.a < node; });
        std::size_t best = sides_.size();
        double least = 0.0;
        const Vec2 back = at(side.a) - at(side.b);
        for (auto it = first; it != sides_.end() && it->a == side.b; ++it) {
            const auto k = static_cast<std::size_t>(it - sides_.begin());
            const Vec2 ahead = at(it->b) - at(side.b);
            double turn = std::atan2(-cross(back, ahead), dot(back, ahead));
            turn += turn <= 0.0 ? 2.0 * std::numbers::pi : 0.0;
            if (best == sides_.size() || turn < least) {
                best = k;
                least = turn;
            }
        }
        return best;
    }

    /// Follows the sides until the loop closes.
    std::vector<std::size_t> loopFrom(std::size_t k) {
        std::vector<std::size_t> loop;
        for (; k < sides_.size() && used_[k] == 0; k = next(sides_[k])) {
            used_[k] = 1;
            loop.push_back(k);
        }
        return loop;
    }

    double twiceArea(const std::vector<std::size_t> &loop) const {
        double area = 0.0;
        const Vec2 origin = at(sides_[loop.front()].a);
        for (const std::size_t k : loop) {
            area += cross(at(sides_[k].a) - origin, at(sides_[k].b) - origin);
        }
        return area;
    }

    /// Adds the stretches of a loop: sides of one part each.
    void divide(std::vector<std::size_t> loop, std::vector<std::pair<std::size_t, ShoreStretch>> &found) const {
        using Kind = ShoreStretch::Kind;
        std::size_t start = 0;
        while (start < loop.size() && part(loop, start) == part(loop, start + loop.size() - 1)) {
            ++start;
        }
        const bool whole = start == loop.size();
        std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(whole ? 0 : start), loop.end());
        const bool island = whole && part(loop, 0) == kLand && twiceArea(loop) < 0.0;
        for (std::size_t k = 0; k < loop.size();) {
            const std::size_t here = part(loop, k);
            ShoreStretch stretch{here != kLand ? Kind::Open : island ? Kind::Island : Kind::Land, {}};
            for (; k < loop.size() && part(loop, k) == here; ++k) {
                stretch.nodes.push_back(sides_[loop[k]].a);
            }
            if (!island) {
                stretch.nodes.push_back(sides_[loop[k - 1]].b);
            }
            found.emplace_back(here != kLand ? here : island ? kLand : kLand - 1, std::move(stretch));
        }
    }

    std::size_t part(const std::vector<std::size_t> &loop, std::size_t k) const {
        return sides_[loop[k % loop.size()]].part;
    }

    const MeshView &mesh_;
    std::vector<ShoreSide> sides_; ///< by their nodes
    std::vector<std::uint8_t> used_;
};

} // namespace

std::vector<ShoreStretch> shoreline(const MeshView &mesh, std::span<const std::int32_t> openTags) {
    return Shore(mesh, openTags).stretches();
}

} // namespace forefront
