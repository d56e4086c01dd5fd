#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/mesh/mesh_view.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace FOREFRONT_API forefront {

/// A side of an element as one number. Sides are numbered through all elements in turn: in a mesh of triangles, side k
/// of element e is 3·e + k. Side k runs from corner k of its element to the next corner.
using HalfEdge = std::uint32_t;

inline constexpr HalfEdge kNoHalfEdge = kNoIndex;

/// The numbers of the sides of a mesh's elements. It does not refer to the mesh.
class HalfEdgeNumbers {
  public:
    HalfEdgeNumbers() = default;
    /// There may be at most kNoIndex sides.
    explicit HalfEdgeNumbers(const MeshView &mesh);

    /// Returns the number of sides of all elements.
    std::uint32_t count() const { return rows_.empty() ? 0 : rows_.back().end; }
    HalfEdge of(std::size_t element, std::size_t side) const {
        const Row &row = rowOfElement(element);
        return row.begin + static_cast<HalfEdge>(row.corners * (element - row.firstElement) + side);
    }
    std::size_t elementOf(HalfEdge h) const {
        const Row &row = rowOf(h);
        return row.firstElement + row.elementIn(h);
    }
    unsigned sideOf(HalfEdge h) const {
        const Row &row = rowOf(h);
        return row.sideIn(h);
    }
    /// Returns the number of sides of an element.
    unsigned sidesOf(std::size_t element) const { return rowOfElement(element).corners; }
    /// Returns the next side of the same element, counter-clockwise.
    HalfEdge next(HalfEdge h) const {
        const Row &row = rowOf(h);
        return row.sideIn(h) + 1U == row.corners ? h + 1U - row.corners : h + 1U;
    }

  protected:
    /// The sides of the elements of a block.
    struct Row {
        HalfEdge begin = 0, end = 0;
        std::uint32_t firstElement = 0, endElement = 0;
        unsigned corners = 3;
        unsigned nodes = 3;                   ///< of an element
        bool second = false;                  ///< whether the edges of the elements have middle nodes
        const NodeId *connectivity = nullptr; ///< only for HalfEdges

        std::uint32_t elementIn(HalfEdge h) const { return corners == 3 ? (h - begin) / 3U : (h - begin) / 4U; }
        unsigned sideIn(HalfEdge h) const { return corners == 3 ? (h - begin) % 3U : (h - begin) % 4U; }
    };

    const Row &rowOf(HalfEdge h) const {
        const Row *row = rows_.data();
        while (h >= row->end) {
            ++row;
        }
        return *row;
    }
    const Row &rowOfElement(std::size_t element) const {
        const Row *row = rows_.data();
        while (element >= row->endElement) {
            ++row;
        }
        return *row;
    }

    std::vector<Row> rows_;
};

/// The sides of a mesh's elements with their nodes. Valid only as long as the mesh exists unchanged.
class HalfEdges : public HalfEdgeNumbers {
  public:
    explicit HalfEdges(const MeshView &mesh);

    NodeId startOf(HalfEdge h) const {
        if (triangles_ != nullptr) {
            return triangles_[h];
        }
        const Row &row = rowOf(h);
        return nodesIn(row, h)[row.sideIn(h)];
    }
    NodeId endOf(HalfEdge h) const {
        if (triangles_ != nullptr) {
            return triangles_[h % 3U == 2U ? h - 2U : h + 1U];
        }
        const Row &row = rowOf(h);
        return nodesIn(row, h)[(row.sideIn(h) + 1U) % row.corners];
    }
    /// Returns the node in the middle of the side, or kNoNode if its element is of first order.
    NodeId middleOf(HalfEdge h) const {
        const Row &row = rowOf(h);
        return row.second ? nodesIn(row, h)[row.corners + row.sideIn(h)] : kNoNode;
    }

  private:
    static const NodeId *nodesIn(const Row &row, HalfEdge h) {
        return row.connectivity + std::size_t{row.nodes} * row.elementIn(h);
    }

    const NodeId *triangles_ = nullptr; ///< the nodes of a mesh of triangles of 3 nodes in one block: the fast path
};

} // namespace forefront
