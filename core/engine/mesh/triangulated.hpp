#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/mesh/mesh.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/mesh/tri_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace FOREFRONT_API forefront {

/// Triangles of 3 nodes in place of the elements of a mesh, on the same nodes.
struct Triangulated {
    TriMesh mesh;
    /// The element that each triangle is a part of; empty if all elements are triangles of 3 nodes.
    std::vector<std::uint32_t> elementOf;
    /// Per triangle, bit k: its edge k is an edge of the element or half of one, rather than a line inside the element.
    /// Empty if all elements are triangles of 3 nodes.
    std::vector<std::uint8_t> realEdges;

    std::size_t element(std::size_t triangle) const { return elementOf.empty() ? triangle : elementOf[triangle]; }
    bool isReal(std::size_t triangle, std::size_t edge) const {
        return realEdges.empty() || ((realEdges[triangle] >> edge) & 1U) != 0;
    }
    /// Returns the value of its element for each triangle.
    template <class T>
    std::vector<T> ofTriangles(std::vector<T> ofElements) const {
        if (elementOf.empty()) {
            return ofElements;
        }
        std::vector<T> values;
        values.reserve(elementOf.size());
        for (const std::uint32_t e : elementOf) {
            values.push_back(ofElements[e]);
        }
        return values;
    }
};

/// Splits all elements into triangles of 3 nodes and keeps the nodes: a quadrilateral into two along its better
/// diagonal, which lies inside; a triangle of 6 nodes into four; a quadrilateral of 8 nodes into six and one of 9 into
/// eight. A tagged edge of 3 nodes becomes two.
Triangulated triangulated(const MeshView &mesh);
/// Does the same without copying the arrays that do not change.
Triangulated takeTriangulated(Mesh mesh);

} // namespace forefront
