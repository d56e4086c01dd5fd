#pragma once

#include "core/engine/mesh/fault_list.hpp"
#include "core/engine/mesh/mesh_numbers.hpp"
#include "core/engine/mesh/mesh_view.hpp"

#include <cstdint>
#include <string>

namespace forefront {

/// A mesh with the numbers that messages use.
struct NumberedMesh {
    const MeshView &mesh;
    const MeshNumbers &numbers;

    std::string node(NodeId n) const { return std::to_string(numbers.nodes.of(index(n))); }
    std::string edge(NodeId a, NodeId b) const { return node(a) + '-' + node(b); }
    std::string element(std::size_t e) const { return "element " + std::to_string(numbers.elements.of(e)); }
    Vec2 at(NodeId n) const { return mesh.nodes[index(n)]; }
    Vec2 middle(NodeId a, NodeId b) const { return midpoint(at(a), at(b)); }
};

/// Adds a fault for each reference to a node that does not exist, and for numbers of parts that cannot be.
void checkIndices(const NumberedMesh &named, FaultList &faults);

/// Adds a fault for each node with a coordinate that is not finite.
void checkFinite(const NumberedMesh &named, FaultList &faults);

/// Adds a fault for each element that refers to a node twice, since its sides cannot be followed. Returns false if
/// there are any.
bool checkNodesDistinct(const NumberedMesh &named, FaultList &faults);

/// Adds a fault for each element that is clockwise, has no area, is not convex or folds over itself, and a warning for
/// each that is flat within rounding.
void checkShapes(const NumberedMesh &named, FaultList &faults);

} // namespace forefront
