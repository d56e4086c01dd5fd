#include "core/drawing/arrangement/repeated_lines/beside_outlines.hpp"

#include "core/drawing/arrangement/repeated_lines/line_cuts.hpp"
#include "core/drawing/arrangement/repeated_lines/loose_chains.hpp"
#include "core/drawing/arrangement/repeated_lines/outline_runs.hpp"
#include "core/drawing/arrangement/repeated_lines/outline_search.hpp"
#include "core/engine/base/rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

namespace forefront {

namespace {

/// The places along an edge where its distance from the outlines is measured.
constexpr std::array kPlaces = {0.0, 0.25, 0.5, 0.75, 1.0};

/// Finds the chains that repeat outlines, and parts of others.
class RepeatFinder {
  public:
    RepeatFinder(std::span<const Vec2> nodes, std::span<const PlaneEdge> edges, std::span<const BesideEdge> about,
                 std::span<const Curve> curves)
        : nodes_(nodes), edges_(edges), about_(about), shapes_(nodes, edges, about, curves), outlines_(shapes_, about),
          distance_(edges.size(), 0.0), kept_(nodes.size()) {}

    RepeatedOutlines run() {
        findChains();
        describeNodes();
        std::vector<LineCut> cuts;
        for (std::size_t c = 0; c < chains_.size(); ++c) {
            if (fates_[c] == ChainFate::Stays) {
                cutRuns(chains_[c], cuts);
            }
        }
        keepConnections();
        for (std::size_t c = 0; c < chains_.size(); ++c) {
            for (std::size_t k = 0; k < chains_[c].edges.size() && fates_[c] == ChainFate::Repeats; ++k) {
                const std::uint32_t edge = chains_[c].edges[k];
                cuts.push_back({edge, 0.0, 1.0, {}, {}, distance_[edge]});
            }
        }
        std::vector<std::uint8_t> movable;
        for (const Kept &kept : kept_) {
            movable.push_back(!kept.outline && !kept.line && !kept.attached ? 1 : 0);
        }
        return withoutCuts(std::move(cuts), nodes_, edges_, about_, movable, outlines_);
    }

  private:
    /// The edges at a node that are kept.
    struct Kept {
        bool outline = false;
        bool line = false;     ///< a line that must stay
        bool divides = false;  ///< such a line divides two faces
        bool attached = false; ///< a short line leads to an outline
        bool lacksOutline() const { return divides && !outline && !attached; }
    };
    enum class ChainFate : std::uint8_t { Stays, Repeats };
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
                fates_.push_back(near_.back() != 0 && runsAlong(chains_.back(), lengths_.back()) ? ChainFate::Repeats
                                                                                                 : ChainFate::Stays);
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
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            for (const std::uint32_t node : {edges_[e].a, edges_[e].b}) {
                const bool line = about_[e].role == BesideRole::Line;
                kept_[node].outline = kept_[node].outline || about_[e].role == BesideRole::Outline;
                kept_[node].line = kept_[node].line || line;
                kept_[node].divides = kept_[node].divides || (line && about_[e].divides);
            }
        }
        for (std::size_t c = 0; c < chains_.size(); ++c) {
            if (near_[c] != 0 && fates_[c] == ChainFate::Stays) {
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

    /// Adds the parts of a chain that repeat outlines, except where a line that must stay would lose its connection.
    void cutRuns(const LooseChain &chain, std::vector<LineCut> &cuts) const {
        const std::vector<ChainEdge> path = directed(chain);
        const auto mayEnd = [&](const OutlinePlace &place) {
            const PlaneEdge &edge = edges_[path[place.edge].edge];
            const bool atA = place.part == (path[place.edge].forward ? 0.0 : 1.0);
            const bool inside = place.part > 0.0 && place.part < 1.0;
            return inside || !kept_[atA ? edge.a : edge.b].line || kept_[atA ? edge.a : edge.b].outline;
        };
        for (const ChainRun &run : runsBesideOutlines(path, about_, shapes_, outlines_)) {
            for (std::size_t k = run.from.edge; k <= run.to.edge && mayEnd(run.from) && mayEnd(run.to); ++k) {
                LineCut cut{path[k].edge, 0.0, 1.0, {}, {}, run.distance};
                if (k == run.from.edge && run.from.part > 0.0) {
                    cut.from = run.from.part;
                    cut.before = run.from.outline;
                }
                if (k == run.to.edge && run.to.part < 1.0) {
                    cut.to = run.to.part;
                    cut.beyond = run.to.outline;
                }
                if (!path[k].forward) {
                    cut = {cut.edge, 1.0 - cut.to, 1.0 - cut.from, cut.beyond, cut.before, cut.distance};
                }
                if (cut.from < cut.to) {
                    cuts.push_back(cut);
                }
            }
        }
    }

    /// Returns a chain in a direction that depends on its places alone; a loop begins at the node farthest from
    /// outlines.
    std::vector<ChainEdge> directed(const LooseChain &chain) const {
        std::vector<ChainEdge> path;
        std::uint32_t node = chain.ends.empty() ? edges_[chain.edges.front()].b : chain.ends.front();
        for (const std::uint32_t edge : inOrder(chain)) {
            path.push_back({edge, edges_[edge].a == node});
            node = path.back().forward ? edges_[edge].b : edges_[edge].a;
        }
        if (chain.ends.empty()) {
            std::rotate(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(farthestNode(path)), path.end());
        }
        const auto endOf = [&](const ChainEdge &edge, bool ahead) {
            return edge.forward == ahead ? shapes_.b(edge.edge) : shapes_.a(edge.edge);
        };
        const bool closed = chain.ends.empty() || chain.ends.front() == chain.ends.back();
        if (comesBefore(endOf(path.back(), !closed), endOf(path.front(), closed))) {
            std::reverse(path.begin(), path.end());
            for (ChainEdge &edge : path) {
                edge.forward = !edge.forward;
            }
        }
        return path;
    }

    /// Returns the index of the edge of a loop that begins at the node farthest from outlines.
    std::size_t farthestNode(std::span<const ChainEdge> path) const {
        std::size_t best = 0;
        std::pair<double, Vec2> found;
        for (std::size_t k = 0; k < path.size(); ++k) {
            const Vec2 p = path[k].forward ? shapes_.a(path[k].edge) : shapes_.b(path[k].edge);
            const double reach = about_[path[k].edge].reach;
            const auto q = outlines_.placeNear(p, reach);
            const double away = q ? std::min(distance(p, *q), reach) : reach;
            if (k == 0 || away > found.first || (away == found.first && comesBefore(p, found.second))) {
                best = k;
                found = {away, p};
            }
        }
        return best;
    }

    /// Keeps chains at nodes where lines that divide faces would no longer reach an outline.
    void keepConnections() {
        const Rows<std::uint32_t> ending(nodes_.size(), [this](const auto &add) { // chains by their ends
            for (std::uint32_t c = 0; c < chains_.size(); ++c) {
                for (const std::uint32_t end : chains_[c].ends) {
                    add(end, c);
                }
            }
        });
        for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
            const std::span<const std::uint32_t> here = ending[node];
            if (kept_[node].lacksOutline() && !keepShortest(node, here)) {
                for (const std::uint32_t chain : here) {
                    fates_[chain] = ChainFate::Stays;
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
            if (fates_[chain] == ChainFate::Repeats && kept_[farEnd(chain)].outline &&
                (best == kNoIndex || lengths_[chain] < lengths_[best] ||
                 (lengths_[chain] == lengths_[best] && comesBefore(nodes_[farEnd(chain)], nodes_[farEnd(best)])))) {
                best = chain;
            }
        }
        if (best != kNoIndex) {
            fates_[best] = ChainFate::Stays;
            kept_[node].attached = true;
        }
        return best != kNoIndex;
    }

    std::span<const Vec2> nodes_;
    std::span<const PlaneEdge> edges_;
    std::span<const BesideEdge> about_;
    EdgeShapes shapes_;
    OutlineSearch outlines_;
    std::vector<LooseChain> chains_;
    std::vector<double> lengths_;    // per chain
    std::vector<std::uint8_t> near_; // per chain: within its reach of chords of outlines
    std::vector<ChainFate> fates_;   // per chain
    std::vector<double> distance_;   // per edge of such a chain
    std::vector<Kept> kept_;         // per node
};

} // namespace

RepeatedOutlines findRepeatedOutlines(std::span<const Vec2> nodes, std::span<const PlaneEdge> edges,
                                      std::span<const BesideEdge> about, std::span<const Curve> curves) {
    return RepeatFinder(nodes, edges, about, curves).run();
}

} // namespace forefront
