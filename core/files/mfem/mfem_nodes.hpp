#pragma once

#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/common/planar_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace forefront {

// MFEM gives curved elements by a grid function "nodes" of second order: a place for each vertex, then for each edge,
// then for each quadrilateral. Edges have the numbers in which the elements name them first.

/// Numbers edges as MFEM does.
class MfemEdges {
  public:
    /// Returns the number of an edge, a new one for an edge that is named for the first time.
    std::size_t add(std::size_t a, std::size_t b);
    std::size_t size() const { return numbers_.size(); }

  private:
    std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
};

/// A mesh of second order as MFEM lists it.
struct MfemNodes {
    /// The vertex of each node that is a corner of an element; kNoIndex for all others.
    std::vector<std::uint32_t> vertexOf;
    std::size_t vertices = 0;
    std::vector<Vec2> places; ///< of the vertices, the edges and the quadrilaterals
};

/// Returns the nodes of a mesh. Edges without a middle node get the middle between their ends; quadrilaterals without a
/// node in their centre get the centre of the quadrilateral of 8 nodes, which leaves their shape as it is.
MfemNodes mfemNodes(const MeshView &mesh);

/// Makes the elements of a mesh those of second order. `elements`: of first order, with nodes below `vertices`, which
/// is their number. `places`: as MfemNodes::places. `quadNodes`: 8, which drops the centres, or 9. Returns the
/// elements, and appends the new nodes to `nodes`, which has the vertices; returns an empty list if the number of
/// places differs from what the elements need, which is then `expected`.
ElementList curvedElements(const ElementList &elements, std::size_t vertices, std::span<const Vec2> places,
                           std::size_t quadNodes, std::vector<Vec2> &nodes, std::size_t &expected);

} // namespace forefront
