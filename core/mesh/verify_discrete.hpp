#pragma once

#include "core/boundary/discretise.hpp"
#include "core/mesh/fault_list.hpp"
#include "core/mesh/mesh.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Finds nodes of a mesh by their exact coordinates. 4 bytes per node looked among.
class NodeFinder {
  public:
    /// Among the nodes of tagged edges and tagged points; among all where the mesh has no tags.
    explicit NodeFinder(const Mesh &mesh);
    /// The node at p, the one of least id where several are, or kNoNode.
    NodeId find(Vec2 p) const;

  private:
    const Mesh *mesh_;
    std::vector<NodeId> sorted_;
};

/// True for a mesh from a file format without tags: then tags and regions are not compared.
bool carriesNoTags(const Mesh &mesh);

/// The faults of verifyAgainst(mesh, discrete domain), for a mesh whose indices are valid.
void checkAgainst(const Mesh &mesh, const DiscreteDomain &domain, FaultList &faults);

/// Area enclosed by the segments that have the outside on one side, and the sum of the sizes of its terms, the scale
/// of the rounding error.
struct EnclosedArea {
    double area = 0.0;
    double magnitude = 0.0;
};
EnclosedArea enclosedArea(const DiscreteDomain &domain);
/// Σ element areas, from differences of coordinates.
double meshArea(const Mesh &mesh);

} // namespace forefront
