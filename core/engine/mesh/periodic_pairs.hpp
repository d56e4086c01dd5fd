#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesh/mesh_numbers.hpp"
#include "core/engine/mesh/mesh_view.hpp"

#include <vector>

namespace FOREFRONT_API forefront {

/// A node of the first part of a periodic link, and the node of the second part that its image is.
struct NodePair {
    NodeId from;
    NodeId to;

    friend bool operator==(const NodePair &, const NodePair &) = default;
};

/// The pairs of nodes of one periodic link.
struct PeriodicPairs {
    PeriodicLink link;
    std::vector<NodePair> pairs; ///< by the first node; a node that is its own image is left out
    double deviation = 0.0;      ///< the greatest distance of a second node from the image of the first, domain units
    std::size_t exact = 0;       ///< pairs whose second node is the image to the bit
};

/// Returns the pairs of nodes of a periodic link of a mesh, the middle nodes of edges of second order included. Nodes
/// whose image is not among the nodes of the other part are left out; see verifyPeriodic().
PeriodicPairs periodicPairs(const MeshView &mesh, const PeriodicLink &link);

/// Returns the faults of the periodic links of a mesh: a node or edge of one part without its image on the other within
/// kPeriodicTolerance of the size of the mesh ("periodic-pairs", with the place). `numbers`: of the nodes in messages.
Diagnostics verifyPeriodic(const MeshView &mesh, const MeshNumbers &numbers = {});

/// Moves the nodes in the middles of edges of second parts onto the images of those of the first parts, from which
/// rounding may separate them. The mesh must have passed verifyPeriodic().
void alignMiddleNodes(Mesh &mesh);

} // namespace forefront
