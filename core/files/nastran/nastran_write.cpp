#include "core/engine/base/number_text.hpp"
#include "core/files/common/names.hpp"
#include "core/files/common/part_groups.hpp"
#include "core/files/common/tagged_cells.hpp"
#include "core/files/nastran/nastran.hpp"
#include "core/files/nastran/nastran_real.hpp"
#include "core/files/text/columns.hpp"

#include <span>
#include <string>

namespace forefront {

namespace {

constexpr std::size_t kSmall = 8, kLarge = 16; ///< characters of a field

/// Property numbers fill a small field at most; names are in comments only.
constexpr GroupLimits kNastranGroups = {99'999'999, 0, nullptr};

const char *cardOf(CellKind kind) {
    switch (kind) {
    case CellKind::Triangle3:
        return "CTRIA3  ";
    case CellKind::Triangle6:
        return "CTRIA6  ";
    case CellKind::Quadrilateral4:
        return "CQUAD4  ";
    case CellKind::Quadrilateral8:
        return "CQUAD8  ";
    default:
        return "CROD    ";
    }
}

void writeLargeReal(TextWriter &out, double value) {
    const std::string text = nastranReal(value, kLarge).text;
    out << std::string_view("                ").substr(text.size()) << text;
}

/// Writes a card in small fields, eight on a line after its name.
void writeCard(TextWriter &out, CellKind kind, std::uint64_t number, std::int32_t property,
               std::span<const NodeId> nodes) {
    out << cardOf(kind);
    writeColumn(out, number, kSmall);
    writeColumn(out, property, kSmall);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        out << (k == 6 ? "+\n+       " : "");
        writeColumn(out, index(nodes[k]) + std::uint64_t{1}, kSmall);
    }
    out << '\n';
}

} // namespace

/// Writes grid points in large fields, elements with the property of their region, and rods between the ends of
/// boundary edges with the property of their boundary part. Comments keep names, tags and points.
void writeNastran(const MeshView &mesh, TextWriter &out) {
    const PartGroups groups(mesh, kNastranGroups);
    out << "$ " << titleOf(mesh) << '\n';
    groups.writeOrigins("$", out);
    for (const TaggedNode &point : mesh.points) {
        out << "$ point " << index(point.node) + std::uint64_t{1} << ' ' << point.tag << '\n';
    }
    out << "BEGIN BULK\n";
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << "GRID*   ";
        writeColumn(out, n + 1, kLarge);
        out << "                "; // basic coordinates
        writeLargeReal(out, mesh.nodes[n].x);
        writeLargeReal(out, mesh.nodes[n].y);
        out << "*\n*                     0.\n";
    }
    std::uint64_t number = 0;
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size() && out.ok(); ++k) {
            writeCard(out, block.kind, ++number, groups.of(2, block.region(k)).number, block.nodesOf(k));
        }
    }
    for (const TaggedEdge &edge : mesh.edges) {
        const NodeId ends[] = {edge.a, edge.b};
        writeCard(out, CellKind::Edge2, ++number, groups.of(1, edge.tag).number, ends);
    }
    out << "ENDDATA\n";
}

Diagnostics noteNastranChanges(const MeshView &mesh) {
    std::size_t rounded = 0;
    for (const Vec2 node : mesh.nodes) {
        rounded += nastranReal(node.x, kLarge).rounded ? 1 : 0;
        rounded += nastranReal(node.y, kLarge).rounded ? 1 : 0;
    }
    if (rounded == 0) {
        return {};
    }
    Diagnostic note;
    note.severity = Severity::Note;
    note.code = "rounded-coordinates";
    note.message = countText(rounded, "coordinate") + (rounded == 1 ? " is" : " are") +
                   " rounded to the 16 characters of a large field";
    return {note};
}

} // namespace forefront
