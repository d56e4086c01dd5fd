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
    double minAngleElsewhere = 0.0;   ///< least angle of the elements that lie in none of these corners, degrees
};

/// The meshed corners between neighbouring tagged edges that are sharper than `limit` degrees. O(elements).
SharpCorners sharpCorners(const Mesh &mesh, double limit);

} // namespace forefront
