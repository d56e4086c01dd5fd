#pragma once

#include "core/engine/mesh/mesh.hpp"
#include "core/files/common/element_list.hpp"
#include "core/files/common/node_table.hpp"
#include "core/files/text/text_scanner.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace forefront {

/// For each node of a cell in the order of a file, its place in the order of CellTraits.
using CellOrder = std::array<std::uint8_t, kMaxCellNodes>;

/// Returns the kind of cell that has this number in a format, such as CellTraits::gmsh; none for other numbers.
std::optional<CellKind> cellNumbered(int CellTraits::*format, std::int64_t number);
/// Returns the kind of element with this number of nodes; none if there is none. No two have the same number.
std::optional<CellKind> elementOfNodes(std::int64_t nodes);
/// The cells that can be read, for messages.
inline constexpr const char *kReadableCells =
    "points, lines of 2 or 3 nodes, triangles of 3 or 6 nodes and quadrilaterals of 4, 8 or 9 nodes";

/// Builds a mesh while it is read: maps node numbers to indices and checks indices and the third coordinate.
/// Every function returns false after recording a located failure in the scanner it was given.
class PlanarMeshBuilder {
  public:
    Mesh mesh; ///< without elements, which finish() adds
    ElementList elements;
    NodeTable table;

    void reserveNodes(std::size_t count) {
        mesh.nodes.reserve(count);
        table.reserve(count);
    }
    /// Reads x, y and, where `dimension` is 3, z, which must be the same for all nodes.
    bool readNode(TextScanner &scanner, std::int64_t number, int dimension);
    /// Reads the coordinates of a node whose number was added before (for formats that list numbers and coordinates
    /// separately).
    bool readPlace(TextScanner &scanner, std::int64_t number, int dimension, Vec2 &place);
    /// Records the third coordinate of a node, found at byte `offset`.
    void noteHeight(double z, std::size_t offset);
    /// Refuses duplicate numbers and nodes that are not in one plane. Call after the last node.
    bool finishNodes(TextScanner &scanner);

    /// Reads the number of a known node.
    bool readNodeId(TextScanner &scanner, NodeId &id, Expect expect);
    /// Reads all nodes of an element. `order`: for each of them, its place in the order of CellTraits.
    bool readElement(TextScanner &scanner, CellKind kind, std::int32_t region, Expect expect,
                     const CellOrder &order = kSameOrder);
    /// Reads an edge: its ends, then its middle node if the kind has one.
    bool readEdge(TextScanner &scanner, CellKind kind, std::int32_t tag, Expect expect,
                  const CellOrder &order = kSameOrder);
    bool readPoint(TextScanner &scanner, std::int32_t tag, Expect expect);
    /// Adds the points of the comment lines `PREFIX point NODE TAG`, for formats that hold no points. Skips values that
    /// do not fit the mesh, since these are only comments.
    void readPointComments(const TextScanner &scanner, std::string_view prefix);
    /// Adds a point, an edge or an element.
    void addCell(CellKind kind, std::span<const NodeId> nodes, std::int32_t tag);
    /// Gives tagged edges without a middle node the middle node of the adjacent elements, for formats that list only
    /// the ends of edges.
    void findMiddles();
    /// Returns the mesh, which can be done once.
    Mesh finish();

  private:
    bool readNodes(TextScanner &scanner, CellKind kind, Expect expect, const CellOrder &order,
                   std::array<NodeId, kMaxCellNodes> &nodes);

    double minZ_ = 0.0, maxZ_ = 0.0;
    std::size_t outOfPlane_ = 0; ///< byte offset of the first node that is not in the plane of node 0
    bool anyNode_ = false, anyOutOfPlane_ = false;
};

/// Refuses an element or edge that refers to a node twice, which has no area or length. Records the failure at `offset`
/// and returns false.
bool requireDistinct(TextScanner &scanner, std::size_t offset, std::span<const NodeId> nodes, Expect expect);

/// Reads a tag; 0 and negative ones are left to raiseTags().
bool readTag(TextScanner &scanner, std::int32_t &tag, Expect expect);

} // namespace forefront
