#include "core/files/common/planar_mesh.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace forefront {

bool PlanarMeshBuilder::readPlace(TextScanner &scanner, std::int64_t number, int dimension, Vec2 &place) {
    const Expect expect{"the coordinates of node", static_cast<std::uint64_t>(number)};
    if (!scanner.real(place.x, expect) || !scanner.real(place.y, expect)) {
        return false;
    }
    double z = 0.0;
    if (dimension == 3) {
        const std::size_t offset = scanner.offset();
        if (!scanner.real(z, expect)) {
            return false;
        }
        noteHeight(z, offset);
    }
    return true;
}

void PlanarMeshBuilder::noteHeight(double z, std::size_t offset) {
    if (!anyNode_) {
        minZ_ = maxZ_ = z;
        anyNode_ = true;
    }
    if (z != minZ_ && !anyOutOfPlane_) {
        anyOutOfPlane_ = true;
        outOfPlane_ = offset;
    }
    minZ_ = std::min(minZ_, z);
    maxZ_ = std::max(maxZ_, z);
}

bool PlanarMeshBuilder::readNode(TextScanner &scanner, std::int64_t number, int dimension) {
    Vec2 place;
    if (!readPlace(scanner, number, dimension, place)) {
        return false;
    }
    mesh.nodes.push_back(place);
    table.add(number);
    return true;
}

bool PlanarMeshBuilder::finishNodes(TextScanner &scanner) {
    if (!scanner.ok()) {
        return false;
    }
    if (mesh.nodes.size() >= kNoIndex) {
        return scanner.fail(scanner.offset(), "too-large", "too many nodes");
    }
    const std::uint32_t twin = table.finish();
    if (twin != kNoIndex) {
        return scanner.fail(scanner.offset(), "duplicate-node",
                            "node " + std::to_string(twin + std::uint64_t{1}) +
                                " of the list repeats the number of an earlier node");
    }
    constexpr double kFlat = 1e-9;
    if (maxZ_ - minZ_ > kFlat * mesh.bounds().diagonal()) {
        return scanner.fail(outOfPlane_, "not-planar", "the nodes do not lie in one plane z = constant",
                            "only planar meshes can be read");
    }
    return true;
}

bool PlanarMeshBuilder::readNodeId(TextScanner &scanner, NodeId &id, Expect expect) {
    std::int64_t number = 0;
    if (!scanner.integer(number, std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max(),
                         expect)) {
        return false;
    }
    const std::uint32_t found = table.find(number);
    if (found == kNoIndex) {
        return scanner.fail(scanner.offset(), "bad-index",
                            expect.words() + " refers to node " + std::to_string(number) + ", which does not exist");
    }
    id = NodeId{found};
    return true;
}

bool PlanarMeshBuilder::readElement(TextScanner &scanner, std::int32_t region, Expect expect) {
    Element element{};
    scanner.peek();
    const std::size_t offset = scanner.offset();
    for (NodeId &node : element) {
        if (!readNodeId(scanner, node, expect)) {
            return false;
        }
    }
    if (!requireDistinct(scanner, offset, element, expect)) {
        return false;
    }
    addElement(element, region);
    return true;
}

bool PlanarMeshBuilder::readEdge(TextScanner &scanner, std::int32_t tag, Expect expect) {
    TaggedEdge edge;
    edge.tag = tag;
    scanner.peek();
    const std::size_t offset = scanner.offset();
    if (!readNodeId(scanner, edge.a, expect) || !readNodeId(scanner, edge.b, expect) ||
        !requireDistinct(scanner, offset, std::array{edge.a, edge.b}, expect)) {
        return false;
    }
    mesh.edges.push_back(edge);
    return true;
}

bool PlanarMeshBuilder::readPoint(TextScanner &scanner, std::int32_t tag, Expect expect) {
    TaggedNode point;
    point.tag = tag;
    if (!readNodeId(scanner, point.node, expect)) {
        return false;
    }
    mesh.points.push_back(point);
    return true;
}

bool requireDistinct(TextScanner &scanner, std::size_t offset, std::span<const NodeId> nodes, Expect expect) {
    for (std::size_t k = 1; k < nodes.size(); ++k) {
        if (std::find(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(k), nodes[k]) !=
            nodes.begin() + static_cast<std::ptrdiff_t>(k)) {
            return scanner.fail(offset, "degenerate-element", expect.words() + " refers to a node twice",
                                "remove it, or correct its nodes");
        }
    }
    return true;
}

bool readTag(TextScanner &scanner, std::int32_t &tag, Expect expect) {
    std::int64_t number = 0;
    constexpr std::int64_t kGreatest = std::numeric_limits<std::int32_t>::max();
    if (!scanner.integer(number, -kGreatest, kGreatest, expect)) {
        return false;
    }
    tag = static_cast<std::int32_t>(number);
    return true;
}

} // namespace forefront
