#include "core/files/common/names.hpp"
#include "core/files/common/part_groups.hpp"
#include "core/files/common/tagged_cells.hpp"
#include "core/files/text/columns.hpp"
#include "core/files/unv/unv.hpp"
#include "core/files/unv/unv_cells.hpp"
#include "core/files/unv/unv_records.hpp"

#include <span>
#include <string>

namespace forefront {

namespace {

void writeUnvNodes(const MeshView &mesh, TextWriter &out) {
    out << kUnvDelimiter << "  2411\n";
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        writeUnvRow(out, {n + 1, 1, 1, 11});
        writeUnvReal(out, mesh.nodes[n].x);
        writeUnvReal(out, mesh.nodes[n].y);
        writeUnvReal(out, 0.0);
        out << '\n';
    }
    out << kUnvDelimiter;
}

void writeUnvCell(std::uint64_t label, CellKind kind, std::int32_t group, std::span<const NodeId> nodes,
                  TextWriter &out) {
    const auto number = static_cast<std::uint64_t>(group);
    writeUnvRow(out, {label, static_cast<std::uint64_t>(unvType(kind)), number, number, 7, nodes.size()});
    if (traitsOf(kind).dimension == 1) {
        writeUnvRow(out, {0, 1, 1});
    }
    UnvRecord record(out);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        record.add(index(nodes[unvNode(traitsOf(kind), k)]) + std::uint64_t{1});
    }
    record.end();
}

/// Numbers elements from 1 on, then edges.
void writeUnvCells(const MeshView &mesh, const PartGroups &groups, TextWriter &out) {
    out << kUnvDelimiter << "  2412\n";
    std::uint64_t label = 0;
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size() && out.ok(); ++k) {
            writeUnvCell(++label, block.kind, groups.of(2, block.region(k)).number, block.nodesOf(k), out);
        }
    }
    for (const TaggedEdge &edge : mesh.edges) {
        const EdgeNodes nodes(edge);
        writeUnvCell(++label, cellKindOf(edge), groups.of(1, edge.tag).number, std::span(nodes.begin(), nodes.end()),
                     out);
    }
    out << kUnvDelimiter;
}

void writeUnvGroups(const MeshView &mesh, const PartGroups &groups, TextWriter &out) {
    if (groups.groups().empty()) {
        return;
    }
    out << kUnvDelimiter << "  2467\n";
    for (const auto &[tag, elements] : elementsByRegion(mesh)) {
        writeUnvGroup(
            groups.of(2, tag), 8, elements, [](std::uint32_t e) { return e + std::uint64_t{1}; }, out);
    }
    for (const auto &[tag, edges] : edgesByTag(mesh)) {
        writeUnvGroup(
            groups.of(1, tag), 8, edges, [&](std::uint32_t k) { return mesh.elementCount() + k + 1; }, out);
    }
    for (const auto &[tag, points] : pointsByTag(mesh)) {
        writeUnvGroup(
            groups.of(0, tag), 7, points,
            [&](std::uint32_t k) { return index(mesh.points[k].node) + std::uint64_t{1}; }, out);
    }
    out << kUnvDelimiter;
}

} // namespace

/// Writes the datasets 2411 (nodes), 2412 (elements and edges, whose property and material have the number of their
/// group) and 2467 (regions and boundary parts as permanent groups of elements, points as groups of nodes). Lines
/// before the first dataset, which readers skip, keep names and tags that differ in the file.
void writeUnv(const MeshView &mesh, TextWriter &out) {
    const PartGroups groups(mesh, kUnvGroups);
    groups.writeOrigins("#", out);
    writeUnvNodes(mesh, out);
    writeUnvCells(mesh, groups, out);
    writeUnvGroups(mesh, groups, out);
}

Diagnostics noteUnvChanges(const MeshView &mesh) {
    return PartGroups(mesh, kUnvGroups).noteChanges();
}

} // namespace forefront
