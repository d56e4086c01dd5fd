#include "core/arrangement/beside_outlines.hpp"

#include "core/base/ids.hpp"
#include "core/geometry/box_tree.hpp"
#include "core/geometry/polygon.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace forefront {

namespace {

/// The places along an edge where its distance from the outlines is measured.
constexpr std::array kPlaces = {0.0, 0.25, 0.5, 0.75, 1.0};

/// The edges with the curves that they follow.
class EdgeShapes {
  public:
    EdgeShapes(std::span<const Vec2> nodes, std::span<const PlaneEdge> edges, std::span<const BesideEdge> about,
               std::span<const Curve> curves)
        : nodes_(nodes), edges_(edges), about_(about), curves_(curves) {}

    Vec2 a(std::uint32_t edge) const { return nodes_[edges_[edge].a]; }
    Vec2 b(std::uint32_t edge) const { return nodes_[edges_[edge].b]; }

    Vec2 at(std::uint32_t edge, double fraction) const {
        if (!follows(edge) || fraction == 0.0 || fraction == 1.0) {
            return fraction == 1.0 ? b(edge) : lerp(a(edge), b(edge), fraction);
        }
        const CurveStretch &stretch = about_[edge].stretch;
        return curves_[stretch.curve].point(std::lerp(stretch.t0, stretch.t1, fraction));
    }
    /// Returns the place on an edge nearest to p.
    Vec2 nearest(std::uint32_t edge, Vec2 p) const {
        if (!follows(edge)) {
            const Vec2 from = a(edge), along = b(edge) - from;
            return from + std::clamp(dot(p - from, along) / lengthSquared(along), 0.0, 1.0) * along;
        }
        const CurveStretch &stretch = about_[edge].stretch;
        const Curve &curve = curves_[stretch.curve];
        return curve.point(curve.nearest(p, std::min(stretch.t0, stretch.t1), std::max(stretch.t0, stretch.t1)));
    }
    /// Returns the maximum distance of an edge from its curve.
    double deviation(std::uint32_t edge) const {
        const CurveStretch &stretch = about_[edge].stretch;
        return follows(edge) ? curves_[stretch.curve].deviation(stretch.t0, stretch.t1) : 0.0;
    }

  private:
    bool follows(std::uint32_t edge) const { return about_[edge].stretch.curve < curves_.size(); }

    std::span<const Vec2> nodes_;
    std::span<const PlaneEdge> edges_;
    std::span<const BesideEdge> about_;
    std::span<const Curve> curves_;
};

/// Finds the outlines near segments and points.
class OutlineSearch {
  public:
    OutlineSearch(const EdgeShapes &shapes, std::span<const BesideEdge> about) : shapes_(shapes) {
        std::vector<Box2> boxes;
        for (std::uint32_t e = 0; e < about.size(); ++e) {
            if (about[e].role == BesideRole::Outline) {
                edges_.push_back(e);
                deviations_.push_back(shapes.deviation(e));
                boxes.push_back(boxOf(shapes.a(e), shapes.b(e)));
                maxDeviation_ = std::max(maxDeviation_, deviations_.back());
            }
        }
        tree_ = BoxTree(boxes);
    }

    /// Returns true if all points of the segment are within `reach` (positive) of the chords of outlines, apart from
    /// the deviation of these.
    bool accompanies(Vec2 p, Vec2 q, double reach) const {
        const Vec2 middle = midpoint(p, q);
        for (const Vec2 place : {q, p, middle}) { // at corners, several outlines are equally near
            const std::uint32_t nearest = nearestTo(place, reach);
            if (nearest == kNoIndex) {
                return false;
            }
            // The distance from a segment is a convex function: it is greatest at an end.
            if (std::max(distanceTo(nearest, p), distanceTo(nearest, q)) <= reach + deviations_[nearest]) {
                return true;
            }
        }
        return distance(p, q) >= kShortest * reach && middle != p && middle != q && accompanies(q, middle, reach) &&
               accompanies(p, middle, reach);
    }

    /// Returns the place on outlines near a point, whose chord must be within `reach` apart from its deviation.
    std::optional<Vec2> placeNear(Vec2 p, double reach) const {
        const std::uint32_t nearest = nearestTo(p, reach);
        return nearest == kNoIndex ? std::nullopt : std::optional(shapes_.nearest(edges_[nearest], p));
    }

  private:
    /// Fraction of the reach. Shorter parts that no single outline accompanies are too far away.
    static constexpr double kShortest = 1.0 / 16.0;

    std::uint32_t nearestTo(Vec2 p, double reach) const {
        double limit = reach + maxDeviation_;
        return tree_.nearest(p, limit, [&](std::uint32_t outline) { return distanceTo(outline, p); });
    }
    double distanceTo(std::uint32_t outline, Vec2 p) const {
        return distanceToSegment(shapes_.a(edges_[outline]), shapes_.b(edges_[outline]), p);
    }

    const EdgeShapes &shapes_;
    std::vector<std::uint32_t> edges_; // the outlines
    std::vector<double> deviations_;   // likewise
    double maxDeviation_ = 0.0;
    BoxTree tree_;
};

/// Loose lines from one node where they meet anything else to the next.
struct LooseChain {
    std::vector<std::uint32_t> edges; ///< one of them, those on from its end `a`, and those on from its end `b`
    std::size_t before = 0;           ///< number of those on from its end `a`
    std::vector<std::uint32_t> ends;  ///< two nodes; none if it is a loop that meets nothing
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
        LooseChain chain{{edge}, 0, {}};
        taken_[edge] = 1;
        extend(chain, edge, edges_[edge].a);
        chain.before = chain.edges.size() - 1;
        extend(chain, edge, edges_[edge].b);
        return chain;
    }

  private:
    struct Around {
        std::uint32_t count = 0; ///< edges that are not dropped
        std::array<std::uint32_t, 2> loose{kNoIndex, kNoIndex};
    };

    /// Adds the edges on from a node of an edge.
    void extend(LooseChain &chain, std::uint32_t edge, std::uint32_t node) {
        std::uint32_t next = beyond(edge, node);
        while (next != kNoIndex && !taken(next)) {
            taken_[next] = 1;
            chain.edges.push_back(next);
            node = edges_[next].a == node ? edges_[next].b : edges_[next].a;
            next = beyond(next, node);
        }
        if (next == kNoIndex) {
            chain.ends.push_back(node);
        }
    }

    /// Returns the loose line that continues another one at a node; kNoIndex if none does, or anything else meets them.
    std::uint32_t beyond(std::uint32_t edge, std::uint32_t node) const {
        const Around &around = around_[node];
        return around.count != 2 ? kNoIndex : around.loose[around.loose[0] == edge ? 1 : 0];
    }

    std::span<const PlaneEdge> edges_;
    std::vector<Around> around_;
    std::vector<std::uint8_t> taken_;
};

/// Finds the chains that repeat outlines, except those on which another line ends.
class RepeatFinder {
  public:
    RepeatFinder(std::span<const Vec2> nodes, std::span<const PlaneEdge> edges, std::span<const BesideEdge> about,
                 std::span<const Curve> curves)
        : nodes_(nodes), edges_(edges), about_(about), shapes_(nodes, edges, about, curves), outlines_(shapes_, about),
          distance_(edges.size(), 0.0), kept_(nodes.size()) {}

    std::vector<RepeatingEdge> run() {
        findChains();
        describeNodes();
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
    /// The edges at a node that are kept.
    struct Kept {
        bool outline = false;
        bool divides = false;  ///< a line divides two faces
        bool attached = false; ///< a short line leads to an outline
        bool lacksOutline() const { return divides && !outline && !attached; }
    };
    /// A chain that is shorter in relation to its distance leads across to an outline.
    static constexpr double kMinLengthToDistance = 4.0;

    void findChains() {
        LooseLines lines(edges_, about_, nodes_.size());
        for (std::uint32_t e = 0; e < edges_.size(); ++e) {
            if (about_[e].role == BesideRole::LooseLine && !lines.taken(e)) {
                chains_.push_back(lines.take(e));
                lengths_.push_back(0.0);
                for (const std::uint32_t edge : chains_.back().edges) {
                    lengths_.back() += distance(shapes_.a(edge), shapes_.b(edge));
                }
                near_.push_back(isNear(chains_.back()) ? 1 : 0);
                repeats_.push_back(near_.back() != 0 && runsAlong(chains_.back(), lengths_.back()) ? 1 : 0);
            }
        }
    }

    bool isNear(const LooseChain &chain) const {
        return std::all_of(chain.edges.begin(), chain.edges.end(), [&](std::uint32_t edge) {
            return outlines_.accompanies(shapes_.a(edge), shapes_.b(edge),
                                         about_[edge].reach + shapes_.deviation(edge));
        });
    }

    /// Returns true if the curves of a chain that is near outlines are within its reach of their curves, on one side.
    bool runsAlong(const LooseChain &chain, double whole) {
        double farthest = 0.0;
        int side = 0;
        std::uint32_t node = chain.ends.empty() ? edges_[chain.edges.front()].b : chain.ends.front();
        for (const std::uint32_t edge : inOrder(chain)) {
            const bool forward = edges_[edge].a == node;
            node = forward ? edges_[edge].b : edges_[edge].a;
            const Vec2 along = forward ? shapes_.b(edge) - shapes_.a(edge) : shapes_.a(edge) - shapes_.b(edge);
            const double reach = about_[edge].reach;
            for (const double place : kPlaces) {
                const Vec2 p = shapes_.at(edge, place);
                const auto q = outlines_.placeNear(p, reach + shapes_.deviation(edge));
                if (!q || distance(p, *q) > reach) {
                    return false;
                }
                const double turn = cross(along, *q - p);
                if (place > 0.0 && place < 1.0 && std::fabs(turn) > kAside * length(along) * reach) {
                    const int own = turn > 0.0 ? 1 : -1;
                    if (side != 0 && own != side) {
                        return false; // from one outline across to another
                    }
                    side = own;
                }
                distance_[edge] = std::max(distance_[edge], distance(p, *q));
            }
            farthest = std::max(farthest, distance_[edge]);
        }
        return whole >= kMinLengthToDistance * farthest;
    }
    static constexpr double kAside = 1e-3; ///< fraction of the reach; curves that coincide may cross unnoticed

    /// Returns the edges of a chain from its first end to its last; those of a loop from `b` of the first one in the
    /// list.
    std::vector<std::uint32_t> inOrder(const LooseChain &chain) const {
        std::vector<std::uint32_t> ordered = chain.edges;
        std::reverse(ordered.begin(), ordered.begin() + static_cast<std::ptrdiff_t>(chain.before + 1));
        return ordered;
    }

    void describeNodes() {
        std::vector<std::uint8_t> dropped(edges_.size(), 0);
        for (std::size_t c = 0; c < chains_.size(); ++c) {
            for (const std::uint32_t edge : chains_[c].edges) {
                dropped[edge] = repeats_[c];
            }
        }
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            for (const std::uint32_t node : {edges_[e].a, edges_[e].b}) {
                if (about_[e].role != BesideRole::Dropped && dropped[e] == 0) {
                    kept_[node].outline = kept_[node].outline || about_[e].role == BesideRole::Outline;
                    kept_[node].divides = kept_[node].divides || about_[e].divides;
                }
            }
        }
        for (std::size_t c = 0; c < chains_.size(); ++c) {
            if (near_[c] != 0 && repeats_[c] == 0) {
                attach(chains_[c]);
            }
        }
    }

    /// Records that a chain leads from one of its ends to an outline at the other.
    void attach(const LooseChain &chain) {
        if (chain.ends.size() == 2) {
            Kept &first = kept_[chain.ends[0]], &last = kept_[chain.ends[1]];
            first.attached = first.attached || last.outline;
            last.attached = last.attached || first.outline;
        }
    }

    /// Keeps chains at nodes where lines that divide faces would no longer reach an outline.
    void keepConnections() {
        std::vector<std::uint32_t> starts(nodes_.size() + 1, 0); // chains by their ends
        for (const LooseChain &chain : chains_) {
            for (const std::uint32_t end : chain.ends) {
                ++starts[end + 1];
            }
        }
        std::partial_sum(starts.begin(), starts.end(), starts.begin());
        std::vector<std::uint32_t> ending(starts.back()), fill(starts.begin(), starts.end() - 1), open;
        for (std::uint32_t c = 0; c < chains_.size(); ++c) {
            for (const std::uint32_t end : chains_[c].ends) {
                ending[fill[end]++] = c;
                if (repeats_[c] != 0 && kept_[end].lacksOutline()) {
                    open.push_back(end);
                }
            }
        }
        while (!open.empty()) {
            const std::uint32_t node = open.back();
            open.pop_back();
            const std::span<const std::uint32_t> here(ending.data() + starts[node], starts[node + 1] - starts[node]);
            if (kept_[node].lacksOutline() && !keepShortest(node, here)) {
                for (const std::uint32_t chain : here) {
                    keep(chain, open);
                }
            }
        }
    }

    /// Keeps the shortest chain that leads from a node to an outline; returns false if there is none.
    bool keepShortest(std::uint32_t node, std::span<const std::uint32_t> here) {
        std::uint32_t best = kNoIndex;
        const auto farEnd = [&](std::uint32_t chain) {
            return chains_[chain].ends[chains_[chain].ends[0] == node ? 1 : 0];
        };
        for (const std::uint32_t chain : here) {
            if (repeats_[chain] != 0 && kept_[farEnd(chain)].outline &&
                (best == kNoIndex || lengths_[chain] < lengths_[best] ||
                 (lengths_[chain] == lengths_[best] && comesBefore(nodes_[farEnd(chain)], nodes_[farEnd(best)])))) {
                best = chain;
            }
        }
        if (best != kNoIndex) {
            repeats_[best] = 0;
            kept_[node].attached = true;
        }
        return best != kNoIndex;
    }

    void keep(std::uint32_t chain, std::vector<std::uint32_t> &open) {
        if (std::exchange(repeats_[chain], 0) != 0) {
            for (const std::uint32_t end : chains_[chain].ends) {
                kept_[end].divides = true;
                open.push_back(end);
            }
        }
    }

    std::span<const Vec2> nodes_;
    std::span<const PlaneEdge> edges_;
    std::span<const BesideEdge> about_;
    EdgeShapes shapes_;
    OutlineSearch outlines_;
    std::vector<LooseChain> chains_;
    std::vector<double> lengths_;       // per chain
    std::vector<std::uint8_t> near_;    // per chain: within its reach of chords of outlines
    std::vector<std::uint8_t> repeats_; // per chain
    std::vector<double> distance_;      // per edge of such a chain
    std::vector<Kept> kept_;            // per node
};

} // namespace

std::vector<RepeatingEdge> edgesRepeatingOutlines(std::span<const Vec2> nodes, std::span<const PlaneEdge> edges,
                                                  std::span<const BesideEdge> about, std::span<const Curve> curves) {
    return RepeatFinder(nodes, edges, about, curves).run();
}

} // namespace forefront
