#include "core/files/common/planar_mesh.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace forefront {

std::optional<CellKind> cellNumbered(int CellTraits::*format, std::int64_t number) {
    for (const CellKind kind : valuesOf<CellKind>()) {
        if (traitsOf(kind).*format == number) {
            return kind;
        }
    }
    return std::nullopt;
}

std::optional<CellKind> elementOfNodes(std::int64_t nodes) {
    for (const CellKind kind : kElementKinds) {
        if (traitsOf(kind).nodes == nodes) {
            return kind;
        }
    }
    return std::nullopt;
}

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

bool PlanarMeshBuilder::readNodes(TextScanner &scanner, CellKind kind, Expect expect, const CellOrder &order,
                                  std::array<NodeId, kMaxCellNodes> &nodes) {
    const std::size_t count = traitsOf(kind).nodes;
    scanner.peek();
    const std::size_t offset = scanner.offset();
    for (std::size_t k = 0; k < count; ++k) {
        if (!readNodeId(scanner, nodes[order[k]], expect)) {
            return false;
        }
    }
    return requireDistinct(scanner, offset, std::span(nodes).first(count), expect);
}

bool PlanarMeshBuilder::readElement(TextScanner &scanner, CellKind kind, std::int32_t region, Expect expect,
                                    const CellOrder &order) {
    std::array<NodeId, kMaxCellNodes> nodes{};
    if (!readNodes(scanner, kind, expect, order, nodes)) {
        return false;
    }
    elements.add(kind, std::span(nodes).first(traitsOf(kind).nodes), region);
    return true;
}

bool PlanarMeshBuilder::readEdge(TextScanner &scanner, CellKind kind, std::int32_t tag, Expect expect,
                                 const CellOrder &order) {
    std::array<NodeId, kMaxCellNodes> nodes{};
    if (!readNodes(scanner, kind, expect, order, nodes)) {
        return false;
    }
    addCell(kind, std::span(nodes).first(traitsOf(kind).nodes), tag);
    return true;
}

void PlanarMeshBuilder::addCell(CellKind kind, std::span<const NodeId> nodes, std::int32_t tag) {
    switch (traitsOf(kind).dimension) {
    case 0:
        mesh.points.push_back({nodes[0], tag});
        break;
    case 1:
        mesh.edges.push_back({nodes[0], nodes[1], tag, nodes.size() > 2 ? nodes[2] : kNoNode});
        break;
    default:
        elements.add(kind, nodes, tag);
    }
}

void PlanarMeshBuilder::findMiddles() {
    if (!elements.hasSecondOrder()) {
        return;
    }
    std::map<std::pair<NodeId, NodeId>, NodeId> middles;
    for (const TaggedEdge &edge : mesh.edges) {
        middles.emplace(std::minmax(edge.a, edge.b), kNoNode);
    }
    for (std::size_t e = 0; e < elements.size(); ++e) {
        const CellTraits &traits = traitsOf(elements.kindOf(e));
        const std::span<const NodeId> nodes = elements.nodesOf(e);
        for (std::size_t k = 0; k < traits.corners && traits.order == 2; ++k) {
            const auto found = middles.find(std::minmax(nodes[k], nodes[(k + 1) % traits.corners]));
            if (found != middles.end()) {
                found->second = nodes[traits.corners + k];
            }
        }
    }
    for (TaggedEdge &edge : mesh.edges) {
        edge.middle = edge.middle == kNoNode ? middles.at(std::minmax(edge.a, edge.b)) : edge.middle;
    }
}

Mesh PlanarMeshBuilder::finish() {
    mesh.blocks = elements.takeBlocks();
    return std::move(mesh);
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

void PlanarMeshBuilder::readPointComments(const TextScanner &scanner, std::string_view prefix) {
    constexpr std::int64_t kGreatest = std::numeric_limits<std::int32_t>::max();
    const std::string start = std::string(prefix) + " point ";
    const std::string_view text = scanner.source().text;
    for (std::size_t at = text.find(start); at != std::string_view::npos; at = text.find(start, at + 1)) {
        TextScanner line = scanner.part(at + start.size(), std::min(text.find('\n', at), text.size()));
        std::int64_t node = 0, tag = 0;
        if ((at == 0 || text[at - 1] == '\n') && line.integer(node, 0, kGreatest, {"a comment"}) &&
            line.integer(tag, 1, kGreatest, {"a comment"}) && table.find(node) != kNoIndex) {
            mesh.points.push_back({NodeId{table.find(node)}, static_cast<std::int32_t>(tag)});
        }
    }
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
