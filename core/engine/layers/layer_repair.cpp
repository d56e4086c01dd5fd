#include "core/engine/layers/layer_repair.hpp"

#include "core/engine/geometry/box_tree.hpp"
#include "core/engine/geometry/edge_meetings.hpp"
#include "core/engine/geometry/predicates.hpp"
#include "core/engine/layers/layer_limits.hpp"
#include "core/engine/layers/layer_outline.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

namespace forefront {

namespace {

/// The corners of an element between two rays, counter-clockwise; three in the sector of a fan and where a ray ends.
struct LayerCorners {
    std::array<Vec2, 4> at;
    std::size_t count = 4;

    bool isConvex() const {
        for (std::size_t k = 0; k < count; ++k) {
            if (orientation(at[k], at[(k + 1) % count], at[(k + 2) % count]) <= 0) {
                return false;
            }
        }
        return true;
    }
    bool holds(Vec2 p) const {
        for (std::size_t k = 0; k < count; ++k) {
            if (orientation(at[k], at[(k + 1) % count], p) < 0) {
                return false;
            }
        }
        return true;
    }
};

class LayerRepair {
  public:
    LayerRepair(const DiscreteDomain &boundary, std::span<const LayerHeights> heights, std::vector<RayChain> &chains)
        : boundary_(boundary), heights_(heights), chains_(chains), tagOf_(boundary.nodes.size(), 0),
          isPoint_(boundary.nodes.size(), 0) {
        for (const ConstraintPoint &point : boundary.taggedPoints()) {
            tagOf_[point.node] = point.tag;
            isPoint_[point.node] = 1;
        }
        for (const DiscreteSegment &s : boundary.segments) {
            for (const std::uint32_t node : {s.a, s.b}) {
                tagOf_[node] = s.tag;
                isPoint_[node] = 0;
            }
        }
        std::vector<Box2> boxes;
        for (std::uint32_t node = 0; node < boundary.nodes.size(); ++node) {
            if (tagOf_[node] != 0 || isPoint_[node] != 0) {
                nodes_.push_back(node);
                boxes.push_back(boxOf(boundary.nodes[node], boundary.nodes[node]));
            }
        }
        tree_ = BoxTree(boxes);
    }

    /// Returns false when cancelled.
    bool run(const Progress &progress) {
        while (!progress.cancelled() && (unfold() || uncover() || separate())) {
            for (RayChain &chain : chains_) {
                levelLayers(chain);
            }
        }
        return !progress.cancelled();
    }

  private:
    /// Calls visit(k, corners) for the elements between the rays of a column, from the wall up, until it returns false.
    template <class Visit>
    void forElements(const RayChain &chain, std::size_t column, const Visit &visit) const {
        const LayerRay &p = chain.rays[column], &q = chain.rayAfter(column);
        const std::uint32_t both = std::min(p.count, q.count), high = std::max(p.count, q.count);
        const bool fan = RayChain::isFan(chain.columns[column]);
        Vec2 a = p.base, b = q.base;
        for (std::uint32_t k = 0; k < high; ++k) {
            const Vec2 c = k < q.count ? placeOn(q, k + 1, heights_) : b;
            const Vec2 d = k < p.count ? placeOn(p, k + 1, heights_) : a;
            LayerCorners corners{{a, b, c, d}, 4};
            if (fan && k == 0) {
                corners = {{a, c, d, {}}, 3};
            } else if (k >= both) {
                corners = {{a, b, k < q.count ? c : d, {}}, 3};
            }
            if (!visit(k, corners)) {
                return;
            }
            a = d;
            b = c;
        }
    }

    bool unfold() {
        bool changed = false;
        for (RayChain &chain : chains_) {
            for (std::size_t i = 0; i < chain.columns.size(); ++i) {
                std::uint32_t good = kNoIndex;
                forElements(chain, i, [&](std::uint32_t k, const LayerCorners &corners) {
                    good = corners.isConvex() ? good : k;
                    return good == kNoIndex;
                });
                if (good != kNoIndex) {
                    lower(chain, i, good, LayerStop::Fold, boundary_.segments[chain.columns[i].segment].tag);
                    changed = true;
                }
            }
        }
        return changed;
    }

    bool uncover() {
        bool changed = false;
        for (RayChain &chain : chains_) {
            for (std::size_t i = 0; i < chain.columns.size(); ++i) {
                const LayerRay &p = chain.rays[i], &q = chain.rayAfter(i);
                if (p.count == 0 && q.count == 0) {
                    continue;
                }
                Box2 box = boxOf(p.base, q.base);
                box.add(placeOn(p, p.count, heights_));
                box.add(placeOn(q, q.count, heights_));
                tree_.search(box, [&](std::uint32_t item) {
                    const std::uint32_t node = nodes_[item];
                    const bool own = node == p.node || node == q.node || slidesPast(chain, i, node);
                    const bool lowered = !own && lowerBelow(chain, i, node);
                    changed = changed || lowered;
                    return !lowered;
                });
            }
        }
        return changed;
    }

    /// Returns true if a node lies on the segment along which the end of a column slides; it is moved later.
    bool slidesPast(const RayChain &chain, std::size_t column, std::uint32_t node) {
        for (std::size_t e = 0; !chain.closed && e < 2; ++e) {
            const bool beside = e == 0 ? column == 0 : column + 1 == chain.columns.size();
            if (!beside || chain.ends[e].slidesAlong == kNoIndex) {
                continue;
            }
            const std::vector<std::uint32_t> &slid = nodesAlong(chain.ends[e].slidesAlong);
            if (std::binary_search(slid.begin(), slid.end(), node)) {
                return true;
            }
        }
        return false;
    }

    /// Returns the nodes along a segment of the domain, ascending.
    const std::vector<std::uint32_t> &nodesAlong(std::uint32_t source) {
        auto [found, added] = along_.try_emplace(source);
        if (added) {
            for (const DiscreteSegment &s : boundary_.segments) {
                if (s.source == source) {
                    found->second.insert(found->second.end(), {s.a, s.b});
                }
            }
            std::sort(found->second.begin(), found->second.end());
        }
        return found->second;
    }

    bool lowerBelow(RayChain &chain, std::size_t column, std::uint32_t node) {
        std::uint32_t below = kNoIndex;
        forElements(chain, column, [&](std::uint32_t k, const LayerCorners &corners) {
            below = corners.holds(boundary_.nodes[node]) ? k : below;
            return below == kNoIndex;
        });
        if (below == kNoIndex) {
            return false;
        }
        lower(chain, column, below, isPoint_[node] != 0 ? LayerStop::Point : LayerStop::Meeting, tagOf_[node]);
        return true;
    }

    bool separate() {
        constexpr std::size_t kLimit = 100'000;
        const LayerOutline outline = outlineOf(boundary_, chains_, heights_);
        std::vector<std::uint32_t> tops(outline.tops.size());
        std::iota(tops.begin(), tops.end(), 0U);
        const EdgeMeetings meetings = findMeetings(outline.points, outline.edges, tops, kLimit);
        bool changed = false;
        for (const EdgeMeeting &meeting : meetings.list) {
            for (const auto &[top, other] :
                 {std::pair(meeting.first, meeting.second), std::pair(meeting.second, meeting.first)}) {
                if (top < outline.tops.size()) {
                    RayChain &chain = chains_[outline.tops[top].chain];
                    const std::size_t column = outline.tops[top].column;
                    const std::uint32_t high = std::max(chain.rays[column].count, chain.rayAfter(column).count);
                    if (high > 0) {
                        lower(chain, column, high - 1, LayerStop::Meeting, outline.tags[other]);
                        changed = true;
                    }
                }
            }
        }
        return changed;
    }

    void lower(RayChain &chain, std::size_t column, std::uint32_t to, LayerStop why, std::int32_t tag) {
        chain.rays[column].lower(to, why, tag);
        chain.rayAfter(column).lower(to, why, tag);
    }

    const DiscreteDomain &boundary_;
    std::span<const LayerHeights> heights_;
    std::vector<RayChain> &chains_;
    std::vector<std::int32_t> tagOf_;   ///< per node: of a segment or of the point there; 0: neither
    std::vector<std::uint8_t> isPoint_; ///< per node: a constraint point without segments
    std::vector<std::uint32_t> nodes_;  ///< per item of the tree
    BoxTree tree_;
    std::map<std::uint32_t, std::vector<std::uint32_t>> along_; ///< see nodesAlong()
};

} // namespace

bool repairLayers(const DiscreteDomain &boundary, std::span<const LayerHeights> heights, std::vector<RayChain> &chains,
                  const Progress &progress) {
    return LayerRepair(boundary, heights, chains).run(progress);
}

} // namespace forefront
