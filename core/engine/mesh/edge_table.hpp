#pragma once

#include "core/engine/mesh/half_edges.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// All edges of a mesh between corners: the sides of its elements in rows by their lower node, each row ordered by
/// (upper node, half-edge). Takes 4 bytes per side and per node, and time O(n) except for nodes of very high valence,
/// whose rows are sorted. The nodes of the elements must exist, and there may be at most kNoIndex sides. Valid only as
/// long as the mesh exists unchanged.
class EdgeTable {
  public:
    explicit EdgeTable(const MeshView &mesh);

    /// Returns the sides of the elements with their nodes.
    const HalfEdges &halfEdges() const { return sides_; }

    /// Returns the half-edges of the edge that joins two nodes, in either direction, ascending; empty without such an
    /// edge.
    std::span<const HalfEdge> find(NodeId a, NodeId b) const;

    /// Calls visit(lower node, upper node, std::span<const HalfEdge>) for each edge, ordered by its nodes.
    template <class Visit>
    void forEach(Visit &&visit) const {
        for (std::uint32_t lower = 0; lower + 1 < offsets_.size(); ++lower) {
            const std::uint32_t end = offsets_[lower + 1];
            for (std::uint32_t i = offsets_[lower]; i < end;) {
                const std::uint32_t upper = upperNode(ordered_[i]);
                std::uint32_t j = i + 1;
                while (j < end && upperNode(ordered_[j]) == upper) {
                    ++j;
                }
                visit(NodeId{lower}, NodeId{upper}, std::span<const HalfEdge>(&ordered_[i], j - i));
                i = j;
            }
        }
    }

  private:
    std::uint32_t lowerNode(HalfEdge h) const {
        return static_cast<std::uint32_t>(std::min(sides_.startOf(h), sides_.endOf(h)));
    }
    std::uint32_t upperNode(HalfEdge h) const {
        return static_cast<std::uint32_t>(std::max(sides_.startOf(h), sides_.endOf(h)));
    }
    void sortRow(std::uint32_t begin, std::uint32_t end);

    HalfEdges sides_;
    std::vector<std::uint32_t> offsets_;
    std::vector<HalfEdge> ordered_;
};

} // namespace forefront
