#pragma once

#include "core/mesh/mesh.hpp"

#include <vector>

namespace forefront {

/// Where tagged edges meet at an angle that no mesh can avoid.
struct SharpCorner {
    NodeId node = kNoNode;
    Vec2 at;
    double angle = 0.0; ///< between the two edges, degrees
};

struct SharpCorners {
    std::vector<SharpCorner> corners; ///< sharpest first
    double minAngleElsewhere = 0.0;   ///< least angle of the other elements, degrees
};

/// A corner holds the elements at its tip and, from one to the next across their sides, those sharper than the limit
/// that have all nodes on tagged edges: the strip along its two edges where there is no room for a node between.
/// The meshed corners between neighbouring tagged edges that are sharper than `limit` degrees. O(elements).
SharpCorners sharpCorners(const Mesh &mesh, double limit);

} // namespace forefront
