#pragma once

#include "core/engine/boundary/discretise.hpp"
#include "core/engine/mesh/fault_list.hpp"
#include "core/engine/mesh/mesh_numbers.hpp"
#include "core/engine/mesh/mesh_view.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace forefront {

/// Finds nodes of a mesh by their exact coordinates. Takes 4 bytes for each node it looks among.
class NodeFinder {
  public:
    /// Looks among the nodes of tagged edges and tagged points, or among all nodes where the mesh has no tags, or none
    /// inside the domain.
    explicit NodeFinder(const MeshView &mesh, bool innerTags = true);
    /// Returns the node at p, the one with the lowest id if there are several, or kNoNode.
    NodeId find(Vec2 p) const;

  private:
    std::span<const Vec2> nodes_;
    std::vector<NodeId> sorted_;
};

/// Returns true for a mesh without tagged edges and points whose regions are all 1, as from a file format without tags;
/// its tags and regions are not compared. Looks at all elements.
bool carriesNoTags(const MeshView &mesh);

/// Adds the deviations of a mesh from a discrete domain. The indices of the mesh must be valid, its elements
/// counter-clockwise. `numbers`: of the elements of the mesh and of the nodes of the domain, in messages. `innerTags`:
/// whether segments inside the domain must be tagged edges.
void checkAgainst(const MeshView &mesh, const DiscreteDomain &domain, FaultList &faults,
                  const MeshNumbers &numbers = {}, bool innerTags = true);

/// Returns true if a segment has the domain on both sides.
inline bool isInner(const DiscreteSegment &segment) {
    return segment.leftRegion != kOutside && segment.rightRegion != kOutside;
}

/// Turns the elements of a clockwise mesh for a comparison with its domain; `copy` receives the turned mesh.
MeshView turnedRight(const MeshView &mesh, std::optional<Mesh> &copy);

/// An area and a bound on its rounding error.
struct BoundedArea {
    double area = 0.0;
    double error = 0.0;
};
/// Returns the area enclosed by the segments that have the outside on one side.
BoundedArea enclosedArea(const DiscreteDomain &domain);
/// Returns the sum of the areas of the polygons of the elements' corners.
BoundedArea meshArea(const MeshView &mesh);

} // namespace forefront
