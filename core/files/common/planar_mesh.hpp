#pragma once

#include "core/engine/mesh/tri_mesh.hpp"
#include "core/files/common/node_table.hpp"
#include "core/files/text/text_scanner.hpp"

#include <cstdint>
#include <span>
#include <utility>

namespace forefront {

/// Builds a mesh while it is read: maps node numbers to indices and checks indices and the third coordinate.
/// Every function returns false after recording a located failure in the scanner it was given.
class PlanarMeshBuilder {
  public:
    TriMesh mesh;
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
    bool readElement(TextScanner &scanner, std::int32_t region, Expect expect);
    bool readEdge(TextScanner &scanner, std::int32_t tag, Expect expect);
    bool readPoint(TextScanner &scanner, std::int32_t tag, Expect expect);
    void addElement(const Element &element, std::int32_t region) {
        mesh.elements.push_back(element);
        mesh.regions.push_back(region);
    }
    /// Returns the mesh, which can be done once.
    TriMesh finish() { return std::move(mesh); }

  private:
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
