#pragma once

#include "core/engine/mesh/mesh_view.hpp"

#include <vector>

namespace forefront {

/// A corner of tagged edges whose angle no mesh can avoid.
struct SharpCorner {
    NodeId node = kNoNode;
    Vec2 at;
    double angle = 0.0; ///< between the two edges, degrees
};

/// A gap between tagged edges or nodes, filled with elements that have no room for good angles.
struct NarrowPlace {
    Vec2 at;                  ///< centre of its narrowest element
    double width = 0.0;       ///< minimum height of its triangles, or mean width of its quadrilaterals
    std::size_t elements = 0; ///< number of elements sharper than the limit
};

struct SharpCorners {
    std::vector<SharpCorner> corners; ///< sharpest first
    std::vector<NarrowPlace> narrow;  ///< narrowest first
    /// Minimum angle of the elements neither in these places nor beside them, degrees. A sharp element is beside one if
    /// it shares a node with it, directly or through other sharp elements.
    double minAngleElsewhere = 0.0;
};

/// Finds the places of a mesh where the domain itself forces small angles: corners and narrow places. A corner owns the
/// elements at its tip and, from one to the next across their sides, those sharper than `limit` degrees with all nodes
/// on tagged edges or tagged themselves: the band along its two edges without room for a node. The other elements of
/// this kind, side by side, make the narrow places, except those that cut off a flat corner. Sharp elements whose
/// shortest side crosses a gap, as between two tips, count as narrow places. Corners count if adjacent tagged edges are
/// sharper than the limit and elements lie between them. Curved edges count as their chords. O(n log n) in tagged
/// edges.
SharpCorners sharpCorners(const MeshView &mesh, double limit);

} // namespace forefront
