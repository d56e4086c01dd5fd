#pragma once

#include "core/engine/quads/quad_blocks.hpp"
#include "core/engine/quads/quad_cell.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// The elements around each node, in no order: up to 15 beside each other in memory, more in lists of their own.
class NodeCells {
  public:
    void assign(std::size_t nodes) { rows_.assign(nodes, {}); }
    void addNode() { rows_.emplace_back(); }
    std::span<const std::uint32_t> operator[](std::uint32_t node) const {
        const Row &row = rows_[node];
        return row.count <= kInline ? std::span(row.cells.data(), row.count) : std::span(long_[row.cells[0]]);
    }
    std::uint32_t count(std::uint32_t node) const { return rows_[node].count; }
    void add(std::uint32_t node, std::uint32_t cell);
    void remove(std::uint32_t node, std::uint32_t cell);

  private:
    static constexpr std::uint32_t kInline = 15;
    struct Row {
        std::uint32_t count = 0;
        std::array<std::uint32_t, kInline> cells{}; ///< if there are more: the first is an index into `long_`
    };
    std::vector<Row> rows_;
    std::vector<std::vector<std::uint32_t>> long_;
};

/// A part of the plane around a node between two tagged edges, in which elements are counted.
struct NodeSector {
    std::uint32_t from = 0;  ///< node at the other end of the tagged edge that it begins at, counter-clockwise
    std::uint8_t target = 4; ///< number of elements that would make about right angles
};

/// A mesh of quadrilaterals and a few triangles while its elements and nodes change. Nodes of tagged edges and tagged
/// points are fixed, and no change removes a tagged edge.
class QuadWorkspace {
  public:
    /// A mesh that is not changed.
    QuadWorkspace() = default;
    /// `fixed`: nodes that must not move besides those of `tagged`, which holds pairs of nodes.
    QuadWorkspace(std::vector<Vec2> places, std::vector<QuadCell> elements, std::vector<std::uint32_t> elementFaces,
                  std::span<const std::array<std::uint32_t, 2>> tagged, std::span<const std::uint32_t> fixedNodes,
                  const SpacingField &field);

    std::vector<Vec2> nodes;
    std::vector<float> rho; ///< node spacing at each node
    std::vector<QuadCell> cells;
    std::vector<std::uint32_t> faces; ///< per element; empty if there is one face
    NodeCells around;

    CellView view() const { return {nodes, cells, faces}; }
    bool isFixed(std::uint32_t node) const { return fixed_[node] != 0; }
    bool isTagged(std::uint32_t a, std::uint32_t b) const;
    /// Returns the number of elements that a node should have.
    std::uint32_t target(std::uint32_t node) const { return target_[node]; }
    std::uint32_t valence(std::uint32_t node) const { return around.count(node); }
    /// Calls visit(elements, target) for each sector around a node; a node without tagged edges is one.
    template <class Visit>
    void forEachSector(std::uint32_t node, Visit &&visit) const {
        if (sectorOf_[node] == kNoIndex) {
            visit(valence(node), target_[node]);
            return;
        }
        for (std::uint32_t s = sectorOf_[node]; s < sectors_.size() && ownerOf_[s] == node; ++s) {
            visit(cellsInSector(node, sectors_[s].from), sectors_[s].target);
        }
    }
    /// Returns true if some sector around a node has another number of elements than it should.
    bool isIrregular(std::uint32_t node) const;

    void put(std::uint32_t cell, const QuadCell &corners, std::uint32_t face);
    void take(std::uint32_t cell);
    std::uint32_t newCell();
    void release(std::uint32_t cell) { freeCells_.push_back(cell); }
    std::uint32_t newNode(Vec2 place, float spacing);
    void releaseNode(std::uint32_t node) { freeNodes_.push_back(node); }
    std::uint32_t faceOf(std::uint32_t cell) const { return faces.empty() ? 0 : faces[cell]; }

    /// Returns the element with the directed edge a→b, or kNoIndex.
    std::uint32_t cellWith(std::uint32_t a, std::uint32_t b) const;
    /// Returns true if two nodes share an edge.
    bool areJoined(std::uint32_t a, std::uint32_t b) const;
    /// The nodes around a free node, counter-clockwise, and the elements between each and the next.
    struct Ring {
        static constexpr std::size_t kMost = 16;
        std::size_t count = 0; ///< 0: more than kMost, or open
        std::array<std::uint32_t, kMost> nodes{}, cells{};

        /// Returns the place of a node in the ring; `count`: it is not there.
        std::size_t find(std::uint32_t node) const {
            std::size_t i = 0;
            while (i < count && nodes[i] != node) {
                ++i;
            }
            return i;
        }
    };
    Ring ringOf(std::uint32_t node) const;

    /// Evaluates the node spacing at all nodes.
    void renewSpacing(const SpacingField &field);
    double shapeOf(std::uint32_t cell) const { return scaledJacobian(cells[cell], nodes); }
    /// Returns the minimum scaled Jacobian around a node.
    double leastAround(std::uint32_t node) const;

  private:
    void findSectors(std::span<const std::array<std::uint32_t, 2>> tagged);
    std::uint32_t cellsInSector(std::uint32_t node, std::uint32_t from) const;

    std::vector<std::uint8_t> fixed_, target_; ///< per node
    std::vector<std::uint32_t> sectorOf_;      ///< per node: its first sector; kNoIndex: all elements are in one
    std::vector<std::uint32_t> ownerOf_;       ///< per sector: its node
    std::vector<NodeSector> sectors_;
    std::vector<std::uint64_t> tagged_; ///< keys of tagged edges, ascending
    std::vector<std::uint32_t> freeCells_, freeNodes_;
};

} // namespace forefront
