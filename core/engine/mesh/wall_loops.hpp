#pragma once

#include "core/engine/mesh/measures.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// The walls of a mesh as loops that keep their elements on the left, and the distance of each node along its loop.
/// Walls are its boundary, the interfaces of its regions and its tagged edges; those inside have a loop on either side.
/// A node where walls touch lies on several loops, or occurs several times on one.
class WallLoops {
  public:
    WallLoops(const MeshView &mesh, const MeshEdges &edges);

    /// Returns true if a node lies on a wall.
    bool holds(NodeId node) const { return first_[index(node)] != first_[index(node) + 1]; }

    /// Returns true if two nodes on walls face each other: they lie on different loops, or much farther apart along the
    /// walls than in a straight line.
    bool facing(NodeId a, NodeId b) const;

  private:
    /// A side of a wall, directed so that its element is on the left.
    struct Side {
        NodeId from, to;
        std::uint32_t next = kNoIndex; ///< the side that follows; kNoIndex at the end of an open chain
    };
    /// One passage of a loop through a node.
    struct Pass {
        NodeId node;
        std::uint32_t loop;
        double along; ///< distance from the start of the loop
    };

    double directionOf(NodeId from, NodeId to) const;
    std::vector<Side> sidesOf(const MeshEdges &edges) const;
    void join(std::vector<Side> &sides) const;
    void follow(const std::vector<Side> &sides, std::uint32_t start, std::vector<char> &visited);
    void followAll(const std::vector<Side> &sides);
    void sortPasses();
    std::span<const Pass> passes(NodeId node) const;

    MeshView mesh_;
    std::vector<Pass> passes_;         ///< ordered by node
    std::vector<std::uint32_t> first_; ///< per node, its first pass; one more at the end
    std::vector<double> lengths_;      ///< of the loops; infinite for open chains
};

} // namespace forefront
