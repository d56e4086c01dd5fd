#pragma once

#include "core/engine/base/rows.hpp"
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
    bool holds(NodeId node) const { return !passes_[index(node)].empty(); }

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
        NodeId node{};
        std::uint32_t loop = 0;
        double along = 0.0; ///< distance from the start of the loop
    };

    double directionOf(NodeId from, NodeId to) const;
    std::vector<Side> sidesOf(const MeshEdges &edges) const;
    void join(std::vector<Side> &sides) const;
    void follow(const std::vector<Side> &sides, std::uint32_t start, std::vector<char> &visited);
    void followAll(const std::vector<Side> &sides);
    void sortPasses();

    MeshView mesh_;
    std::vector<Pass> found_;     ///< in the order of the loops
    Rows<Pass> passes_;           ///< by node
    std::vector<double> lengths_; ///< of the loops; infinite for open chains
};

} // namespace forefront
