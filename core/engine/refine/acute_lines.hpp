#pragma once

#include "core/engine/mesh/tri_mesh.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace forefront {

/// The lines that the tagged edges of a mesh make: each runs through nodes where exactly two edges continue one another
/// without a corner. Lines that meet at less than 60 degrees are divided at the same distances from where they meet, as
/// J. Ruppert proposed (A Delaunay Refinement Algorithm for Quality 2-Dimensional Mesh Generation, 1995, section 5), so
/// that nodes on one do not call for ever nearer nodes on the other. Follows divisions that it is told of.
class AcuteLines {
  public:
    explicit AcuteLines(const TriMesh &mesh);

    /// Where to divide a tagged edge whose one end is acute: at a power of two as distance from there.
    struct Division {
        bool fromA = true; ///< the acute end is the node a of the edge; else b
        double distance = 0.0;
    };
    /// Returns where to divide a tagged edge; std::nullopt: in the middle.
    std::optional<Division> division(const TriMesh &mesh, std::uint32_t edge) const;
    /// Takes over a division: `node` divides `edge`, whose other half is the last tagged edge of the mesh.
    void divided(std::uint32_t edge, NodeId node);
    /// Returns the corner where two lines meet at less than the angle whose cosine is given, if an element lies between
    /// them with its shortest side across from one to the other at equal distances from there. To divide it would call
    /// for ever nearer nodes. Else kNoNode.
    NodeId spannedCorner(const TriMesh &mesh, const Element &element, double cosine) const;

    /// Returns the corner where two lines meet at less than an angle, if all nodes of an element lie on these lines;
    /// else kNoNode. Curves that touch where they meet leave no room between them.
    NodeId enclosingCorner(const TriMesh &mesh, const Element &element, double cosine) const;

  private:
    struct Corner {
        NodeId node;
        std::uint32_t line, other;
        double cosine; ///< of the angle between the two lines there
    };
    void trace(const TriMesh &mesh);
    void findCorners(const TriMesh &mesh);
    std::uint32_t lineOf(NodeId n) const { return index(n) < lineAt_.size() ? lineAt_[index(n)] : kNoIndex; }
    /// Returns the corner nearest to p where the lines that two nodes lie inside meet.
    std::optional<Corner> between(const TriMesh &mesh, NodeId p, NodeId q) const;

    std::vector<std::uint32_t> lineOfEdge_; ///< per tagged edge
    std::vector<std::uint32_t> lineAt_;     ///< per node: the line that it lies inside, or kNoIndex
    std::vector<Corner> corners_;           ///< by line, then the other
    std::vector<NodeId> acute_;             ///< ends of lines at less than 60 degrees, ascending
    // While lines are traced:
    std::vector<std::uint32_t> offsets_, at_; ///< per node: its tagged edges
};

} // namespace forefront
