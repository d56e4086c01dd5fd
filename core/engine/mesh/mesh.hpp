#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/domain/periodic.hpp"
#include "core/engine/mesh/cell.hpp"
#include "core/engine/mesh/tri_mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace FOREFRONT_API forefront {

/// Elements of one kind.
class CellBlock {
  public:
    /// A block without elements. `kind`: one of kElementKinds.
    explicit CellBlock(CellKind kind = CellKind::Triangle3);
    /// Triangles, which are not copied.
    explicit CellBlock(std::vector<Element> triangles, std::vector<std::int32_t> tags = {})
        : regions(std::move(tags)), rows_(std::move(triangles)) {}

    CellKind kind() const { return kind_; }
    const CellTraits &traits() const { return traitsOf(kind_); }
    std::size_t size() const;
    /// Returns the nodes of all its elements, one element after the other.
    std::span<const NodeId> connectivity() const;
    std::span<NodeId> connectivity();
    /// Returns the nodes of an element, in the order of CellTraits.
    std::span<const NodeId> nodesOf(std::size_t element) const;
    /// Adds an element. `nodes`: as many as the kind has.
    void add(std::span<const NodeId> nodes);
    void reserve(std::size_t elements);
    /// Returns the triangles of a block of CellKind::Triangle3; empty for other kinds.
    std::span<const Element> triangles() const;
    /// Returns the triangles of a block of CellKind::Triangle3 without copying them, and leaves it empty.
    std::vector<Element> takeTriangles() &&;

    /// Region tag per element. The library always fills it in; in a mesh made by hand it may be empty: all 1.
    std::vector<std::int32_t> regions;

  private:
    template <std::size_t N>
    using Rows = std::vector<std::array<NodeId, N>>;

    CellKind kind_ = CellKind::Triangle3;
    std::variant<Rows<3>, Rows<4>, Rows<6>, Rows<8>, Rows<9>> rows_;
};

/// A mesh with tags. Its elements lie in blocks, one for each kind that it has, and are numbered through all blocks in
/// turn.
struct Mesh {
    std::vector<Vec2> nodes;
    std::vector<CellBlock> blocks;
    std::vector<TaggedEdge> edges;  ///< boundary and constraint edges
    std::vector<TaggedNode> points; ///< constraint points
    std::vector<Curve> curves;      ///< those that tagged edges are chords of
    /// As TriMesh::edgeStretches.
    std::vector<CurveStretch> edgeStretches;
    std::vector<PeriodicLink> periodic; ///< see periodicPairs()
    std::map<std::int32_t, std::string> boundaryNames;
    std::map<std::int32_t, std::string> regionNames;

    Mesh() = default;
    /// A mesh of triangles; nothing is copied.
    Mesh(TriMesh triangles); // NOLINT(google-explicit-constructor): each mesh of triangles is a mesh

    /// Returns the number of elements.
    std::size_t elementCount() const;
    /// Returns the block of a kind, which is added if the mesh has none.
    CellBlock &block(CellKind kind);
    /// Returns the nodes of the triangles of 3 nodes; empty if the mesh has none.
    std::span<const Element> triangles() const;
    /// Returns true if all elements are triangles of 3 nodes.
    bool isTriangular() const;
    Box2 bounds() const;
};

/// Returns the mesh as one of triangles of 3 nodes, without copying. It must be triangular.
TriMesh takeTriMesh(Mesh mesh);

} // namespace forefront
