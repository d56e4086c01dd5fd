#include "core/arrangement/beside_outlines.hpp"

#include "core/base/ids.hpp"
#include "core/geometry/box_tree.hpp"
#include "core/geometry/polygon.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace forefront {

namespace {

/// Measures how far segments are from outlines.
class OutlineDistance {
  public:
    OutlineDistance(std::span<const Vec2> nodes, std::span<const PlaneEdge> edges, std::span<const BesideEdge> about) {
        std::vector<Box2> boxes;
        for (std::size_t e = 0; e < edges.size(); ++e) {
            if (about[e].role == BesideRole::Outline) {
                outlines_.push_back({nodes[edges[e].a], nodes[edges[e].b], about[e].deviation});
                boxes.push_back(boxOf(outlines_.back().a, outlines_.back().b));
                maxDeviation_ = std::max(maxDeviation_, about[e].deviation);
            }
        }
        tree_ = BoxTree(boxes);
    }

    /// Returns true if all points of the segment are within `reach` (positive) of outlines, apart from the deviation of
    /// these.
    bool accompany(Vec2 p, Vec2 q, double reach) const {
        const Vec2 middle = midpoint(p, q);
        for (const Vec2 place : {q, p, middle}) { // at corners, several outlines are equally near
            double limit = reach + maxDeviation_;
            const std::uint32_t nearest = nearestTo(place, limit);
            if (nearest == kNoIndex) {
                return false;
            }
            // The distance from a segment is a convex function: it is greatest at an end.
            if (std::max(distanceTo(nearest, p), distanceTo(nearest, q)) <= reach + outlines_[nearest].deviation) {
                return true;
            }
        }
        return distance(p, q) >= kShortest * reach && middle != p && middle != q && accompany(q, middle, reach) &&
               accompany(p, middle, reach);
    }

    /// Returns the distance of a point from the nearest outline, at most `limit`.
    double from(Vec2 p, double limit) const {
        nearestTo(p, limit);
        return limit;
    }

  private:
    /// Of the reach. Shorter parts that no single outline accompanies are too far away.
    static constexpr double kShortest = 1.0 / 16.0;

    struct Outline {
        Vec2 a, b;
        double deviation = 0.0;
    };

    /// Returns the nearest outline within the limit, and sets the limit to its distance.
    std::uint32_t nearestTo(Vec2 p, double &limit) const {
        return tree_.nearest(p, limit, [&](std::uint32_t outline) { return distanceTo(outline, p); });
    }
    double distanceTo(std::uint32_t outline, Vec2 p) const {
        return distanceToSegment(outlines_[outline].a, outlines_[outline].b, p);
    }

    std::vector<Outline> outlines_;
    double maxDeviation_ = 0.0;
    BoxTree tree_;
};

/// Loose lines from one node where they meet anything else to the next.
struct LooseChain {
    std::vector<std::uint32_t> edges;
    std::vector<std::uint32_t> ends; ///< two nodes; none if it is a loop that meets nothing
};

/// Divides the loose lines into chains.
class LooseLines {
  public:
    LooseLines(std::span<const PlaneEdge> edges, std::span<const BesideEdge> about, std::size_t nodeCount)
        : edges_(edges), around_(nodeCount), taken_(edges.size(), 0) {
        for (std::uint32_t e = 0; e < edges.size(); ++e) {
            if (about[e].role == BesideRole::Dropped) {
                continue;
            }
            for (const std::uint32_t node : {edges[e].a, edges[e].b}) {
                Around &around = around_[node];
                if (around.count < 2 && about[e].role == BesideRole::LooseLine) {
                    around.loose[around.count] = e;
                }
                ++around.count;
            }
        }
    }

    bool taken(std::uint32_t edge) const { return taken_[edge] != 0; }

    /// Returns the chain through an edge that no chain before it has taken.
    LooseChain take(std::uint32_t edge) {
        LooseChain chain{{edge}, {}};
        taken_[edge] = 1;
        for (std::uint32_t node : {edges_[edge].a, edges_[edge].b}) {
            std::uint32_t last = edge, next = beyond(last, node);
            for (; next != kNoIndex && !taken(next); next = beyond(last, node)) {
                taken_[next] = 1;
                chain.edges.push_back(next);
                node = edges_[next].a == node ? edges_[next].b : edges_[next].a;
                last = next;
            }
            if (next == kNoIndex) {
                chain.ends.push_back(node);
            }
        }
        return chain;
    }

  private:
    struct Around {
        std::uint32_t count = 0; ///< edges that are not dropped
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

/// Finds the chains to drop: first those that repeat outlines, then less those that something ends on.
class RepeatFinder {
  public:
    RepeatFinder(std::span<const Vec2> nodes, std::span<const PlaneEdge> edges, std::span<const BesideEdge> about)
        : nodes_(nodes), edges_(edges), about_(about), outlines_(nodes, edges, about), distance_(edges.size(), 0.0),
          staying_(nodes.size()) {}

    std::vector<RepeatingEdge> run() {
        findChains();
        countStaying();
        keepConnections();
        std::vector<RepeatingEdge> found;
        for (std::size_t c = 0; c < chains_.size(); ++c) {
            for (std::size_t k = 0; k < chains_[c].edges.size() && repeats_[c] != 0; ++k) {
                found.push_back({chains_[c].edges[k], distance_[chains_[c].edges[k]]});
            }
        }
        return found;
    }

  private:
    /// The edges at a node that are not dropped.
    struct Staying {
        std::uint32_t count = 0;
        bool outline = false;
        bool divides = false; ///< one of them divides two faces
        bool looseEnd() const { return count == 1 && divides && !outline; }
    };
    /// A chain is at least this many times as long as it is far from outlines; shorter ones lead across to something.
    static constexpr double kLengthOverDistance = 4.0;

    void findChains() {
        LooseLines lines(edges_, about_, nodes_.size());
        for (std::uint32_t e = 0; e < edges_.size(); ++e) {
            if (about_[e].role == BesideRole::LooseLine && !lines.taken(e)) {
                chains_.push_back(lines.take(e));
                repeats_.push_back(repeatsOutlines(chains_.back()) ? 1 : 0);
            }
        }
    }

    bool repeatsOutlines(const LooseChain &chain) {
        double whole = 0.0, farthest = 0.0;
        for (const std::uint32_t edge : chain.edges) {
            const Vec2 a = nodes_[edges_[edge].a], b = nodes_[edges_[edge].b];
            if (!outlines_.accompany(a, b, about_[edge].reach + about_[edge].deviation)) {
                return false;
            }
            for (const Vec2 p : {a, midpoint(a, b), b}) {
                distance_[edge] = std::max(distance_[edge], outlines_.from(p, about_[edge].reach));
            }
            farthest = std::max(farthest, distance_[edge]);
            whole += distance(a, b);
        }
        return whole >= kLengthOverDistance * farthest;
    }

    /// Counts what stays at the nodes.
    void countStaying() {
        std::vector<std::uint8_t> dropped(edges_.size(), 0);
        for (std::size_t c = 0; c < chains_.size(); ++c) {
            for (const std::uint32_t edge : chains_[c].edges) {
                dropped[edge] = repeats_[c];
            }
        }
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            for (const std::uint32_t node : {edges_[e].a, edges_[e].b}) {
                if (about_[e].role != BesideRole::Dropped && dropped[e] == 0) {
                    Staying &here = staying_[node];
                    here.outline = here.outline || about_[e].role == BesideRole::Outline;
                    here.divides = here.divides || about_[e].divides;
                    ++here.count;
                }
            }
        }
    }

    /// Keeps the chains at whose ends something that stays would end, then those at the other ends of these, and so on.
    void keepConnections() {
        std::vector<std::uint32_t> starts(nodes_.size() + 1, 0); // chains by their ends
        for (const LooseChain &chain : chains_) {
            for (const std::uint32_t end : chain.ends) {
                ++starts[end + 1];
            }
        }
        std::partial_sum(starts.begin(), starts.end(), starts.begin());
        std::vector<std::uint32_t> ending(starts.back()), fill(starts.begin(), starts.end() - 1);
        std::vector<std::uint32_t> open; // nodes with a loose end
        for (std::uint32_t c = 0; c < chains_.size(); ++c) {
            for (const std::uint32_t end : chains_[c].ends) {
                ending[fill[end]++] = c;
                if (staying_[end].looseEnd()) {
                    open.push_back(end);
                }
            }
        }
        while (!open.empty()) {
            const std::uint32_t node = open.back();
            open.pop_back();
            for (std::uint32_t k = starts[node]; k < starts[node + 1]; ++k) {
                if (std::exchange(repeats_[ending[k]], 0) == 0) {
                    continue;
                }
                for (const std::uint32_t end : chains_[ending[k]].ends) {
                    ++staying_[end].count;
                    staying_[end].divides = true;
                    if (end != node && staying_[end].looseEnd()) {
                        open.push_back(end);
                    }
                }
            }
        }
    }

    std::span<const Vec2> nodes_;
    std::span<const PlaneEdge> edges_;
    std::span<const BesideEdge> about_;
    OutlineDistance outlines_;
    std::vector<LooseChain> chains_;
    std::vector<std::uint8_t> repeats_; // per chain
    std::vector<double> distance_;      // per edge of such a chain
    std::vector<Staying> staying_;      // per node
};

} // namespace

std::vector<RepeatingEdge> edgesRepeatingOutlines(std::span<const Vec2> nodes, std::span<const PlaneEdge> edges,
                                                  std::span<const BesideEdge> about) {
    return RepeatFinder(nodes, edges, about).run();
}

} // namespace forefront
