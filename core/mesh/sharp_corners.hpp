#pragma once

#include "core/mesh/mesh.hpp"

#include <vector>

namespace forefront {

/// A corner of tagged edges whose angle no mesh can avoid.
struct SharpCorner {
    NodeId node = kNoNode;
    Vec2 at;
    double angle = 0.0; ///< between the two edges, degrees
};

struct SharpCorners {
    std::vector<SharpCorner> corners; ///< sharpest first
    double minAngleElsewhere = 0.0;   ///< minimum angle of the other elements, degrees
};

/// The corners of a mesh. A corner owns the elements at its tip and, from one to the next across their sides, those
/// sharper than the limit with all nodes on tagged edges: the band along its two edges without room for a node.
/// Finds the meshed corners between adjacent tagged edges that are sharper than `limit` degrees, in time O(elements).
SharpCorners sharpCorners(const Mesh &mesh, double limit);

} // namespace forefront
