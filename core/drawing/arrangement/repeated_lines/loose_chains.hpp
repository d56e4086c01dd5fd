#pragma once

#include "core/drawing/arrangement/repeated_lines/beside_outlines.hpp"
#include "core/engine/base/ids.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

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

    /// Returns the loose line that continues `edge` at a node; kNoIndex if there is none, or if a third edge meets
    /// them.
    std::uint32_t beyond(std::uint32_t edge, std::uint32_t node) const {
        const Around &around = around_[node];
        return around.count != 2 ? kNoIndex : around.loose[around.loose[0] == edge ? 1 : 0];
    }

    std::span<const PlaneEdge> edges_;
    std::vector<Around> around_;
    std::vector<std::uint8_t> taken_;
};

} // namespace forefront
