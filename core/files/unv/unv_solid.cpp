#include "core/files/common/part_groups.hpp"
#include "core/files/common/solid_mesh.hpp"
#include "core/files/unv/unv.hpp"
#include "core/files/unv/unv_records.hpp"

#include <map>
#include <span>

namespace forefront {

namespace {

void writeUnvSolidCell(std::uint64_t label, std::uint64_t type, std::int32_t group,
                       std::span<const std::uint32_t> nodes, TextWriter &out) {
    const auto number = static_cast<std::uint64_t>(group);
    writeUnvRow(out, {label, type, number, number, 7, nodes.size()});
    UnvRecord record(out);
    for (const std::uint32_t node : nodes) {
        record.add(node + std::uint64_t{1});
    }
    record.end();
}

void writeUnvSolidCells(const SolidMesh &mesh, const PartGroups &groups, TextWriter &out) {
    constexpr std::uint64_t kShell3 = 91, kShell4 = 94, kWedge = 112, kBrick = 115;
    out << kUnvDelimiter << "  2412\n";
    std::uint64_t label = 0;
    for (const SolidCell &cell : mesh.cells) {
        writeUnvSolidCell(++label, cell.count == 6 ? kWedge : kBrick, groups.of(2, cell.region).number, cell.nodes(),
                          out);
    }
    for (const SolidFace &face : mesh.faces) {
        writeUnvSolidCell(++label, face.count == 3 ? kShell3 : kShell4, groups.of(1, face.tag).number, face.nodes(),
                          out);
    }
    out << kUnvDelimiter;
}

} // namespace

/// Writes the datasets 2411 (nodes), 2412 (prisms, hexahedra and faces as thin shells) and 2467 (regions and parts as
/// permanent groups of elements).
void writeUnvSolid(const SolidMesh &mesh, TextWriter &out) {
    const PartGroups groups(mesh.tags, kUnvGroups);
    groups.writeOrigins("#", out);
    out << kUnvDelimiter << "  2411\n";
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        writeUnvRow(out, {n + 1, 1, 1, 11});
        for (const double place : mesh.nodes[n]) {
            writeUnvReal(out, place);
        }
        out << '\n';
    }
    out << kUnvDelimiter;
    writeUnvSolidCells(mesh, groups, out);
    std::map<std::int32_t, std::vector<std::uint32_t>> regions, parts;
    for (std::size_t k = 0; k < mesh.cells.size(); ++k) {
        regions[mesh.cells[k].region].push_back(static_cast<std::uint32_t>(k));
    }
    for (std::size_t k = 0; k < mesh.faces.size(); ++k) {
        parts[mesh.faces[k].tag].push_back(static_cast<std::uint32_t>(mesh.cells.size() + k));
    }
    out << kUnvDelimiter << "  2467\n";
    const auto label = [](std::uint32_t element) { return element + std::uint64_t{1}; };
    for (const auto &[tag, cells] : regions) {
        writeUnvGroup(groups.of(2, tag), 8, cells, label, out);
    }
    for (const auto &[tag, faces] : parts) {
        writeUnvGroup(groups.of(1, tag), 8, faces, label, out);
    }
    out << kUnvDelimiter;
}

} // namespace forefront
