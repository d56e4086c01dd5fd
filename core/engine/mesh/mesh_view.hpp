#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/mesh/mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace FOREFRONT_API forefront {

/// A mesh as functions read it: of blocks or of triangles. Like a span, it copies no arrays and is valid only as long
/// as the mesh exists unchanged. Elements are numbered through all blocks in turn.
class MeshView {
  public:
    /// Elements of one kind.
    struct Block {
        CellKind kind = CellKind::Triangle3;
        std::size_t first = 0;                 ///< the number of its first element
        std::span<const NodeId> connectivity;  ///< the nodes of its elements, in the order of CellTraits
        std::span<const std::int32_t> regions; ///< per element; empty: all 1

        const CellTraits &traits() const { return traitsOf(kind); }
        std::size_t size() const { return connectivity.size() / traits().nodes; }
        std::span<const NodeId> nodesOf(std::size_t k) const {
            return connectivity.subspan(k * traits().nodes, traits().nodes);
        }
        std::int32_t region(std::size_t k) const { return regions.empty() ? 1 : regions[k]; }
    };

    MeshView(const TriMesh &mesh); // NOLINT(google-explicit-constructor): a parameter that takes either
    MeshView(const Mesh &mesh);    // NOLINT(google-explicit-constructor)

    std::span<const Vec2> nodes;
    std::span<const TaggedEdge> edges;
    std::span<const TaggedNode> points;
    std::span<const Curve> curves;
    std::span<const CurveStretch> edgeStretches;
    std::span<const PeriodicLink> periodic; ///< a mesh of triangles has none
    /// Elevations of the nodes above the plane, for the formats that hold them; empty: none. Set by the caller of a
    /// writer.
    std::span<const double> elevations;
    const std::map<std::int32_t, std::string> &boundaryNames;
    const std::map<std::int32_t, std::string> &regionNames;

    std::span<const Block> blocks() const {
        return many_.empty() ? std::span(few_).first(blockCount_) : std::span<const Block>(many_);
    }
    std::size_t elementCount() const { return count_; }
    /// Returns the block with this element.
    const Block &blockOf(std::size_t element) const {
        const Block *block = blocks().data();
        while (element - block->first >= block->size()) {
            ++block;
        }
        return *block;
    }
    CellKind kindOf(std::size_t element) const { return blockOf(element).kind; }
    /// Returns all nodes of an element.
    std::span<const NodeId> nodesOf(std::size_t element) const {
        const Block &block = blockOf(element);
        return block.nodesOf(element - block.first);
    }
    /// Returns the corners of an element, counter-clockwise.
    std::span<const NodeId> cornersOf(std::size_t element) const {
        const Block &block = blockOf(element);
        return block.nodesOf(element - block.first).first(block.traits().corners);
    }
    std::int32_t region(std::size_t element) const {
        const Block &block = blockOf(element);
        return block.region(element - block.first);
    }
    /// Returns true if an element has nodes in the middles of its edges.
    bool hasSecondOrder() const;
    /// Returns the elevation of a node; 0 if the mesh has none.
    double elevation(std::size_t node) const { return elevations.empty() ? 0.0 : elevations[node]; }
    Box2 bounds() const;

  private:
    void add(const Block &block);

    /// None of the blocks is empty. A mesh has one of each kind, for which no memory is allocated, unless made by hand.
    std::array<Block, kElementKinds.size()> few_;
    std::vector<Block> many_; ///< all of them, if they are more; else empty
    std::size_t blockCount_ = 0;
    std::size_t count_ = 0; ///< elements
};

/// Returns a copy of the mesh behind a view.
Mesh copyOf(const MeshView &view);

/// Returns a hash of coordinates, elements, regions, edges, points and their tags: equal for meshes that are equal bit
/// for bit, regardless of how their nodes and elements are numbered. Names do not count.
std::uint64_t meshHash(const MeshView &mesh);

} // namespace forefront
