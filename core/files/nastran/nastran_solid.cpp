#include "core/files/common/part_groups.hpp"
#include "core/files/common/solid_mesh.hpp"
#include "core/files/nastran/nastran.hpp"
#include "core/files/nastran/nastran_real.hpp"
#include "core/files/text/columns.hpp"

#include <span>
#include <string>

namespace forefront {

namespace {

constexpr std::size_t kField = 8, kWideField = 16; ///< characters

/// Writes a card in small fields, eight on a line after its name.
void writeSolidCard(const char *name, std::uint64_t number, std::int32_t property, std::span<const std::uint32_t> nodes,
                    TextWriter &out) {
    out << name;
    writeColumn(out, number, kField);
    writeColumn(out, property, kField);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        out << (k == 6 ? "+\n+       " : "");
        writeColumn(out, nodes[k] + std::uint64_t{1}, kField);
    }
    out << '\n';
}

void writeSolidReal(double value, TextWriter &out) {
    const std::string text = nastranReal(value, kWideField).text;
    out << std::string_view("                ").substr(text.size()) << text;
}

} // namespace

/// Writes grid points in large fields, prisms (CPENTA) and hexahedra (CHEXA) with the property of their region, and
/// faces (CTRIA3, CQUAD4) with that of their part. Comments keep names and tags.
void writeNastranSolid(const SolidMesh &mesh, TextWriter &out) {
    const PartGroups groups(mesh.tags, {99'999'999, 0, nullptr});
    out << "$ Extruded mesh\n";
    for (const PartGroup &group : groups.groups()) {
        out << "$ group " << group.number << (group.dimension == 1 ? " boundary " : " region ") << group.tag << " \""
            << percentEncoded(validUtf8(group.name), " ") << "\"\n";
    }
    out << "BEGIN BULK\n";
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << "GRID*   ";
        writeColumn(out, n + 1, kWideField);
        out << "                "; // basic coordinates
        writeSolidReal(mesh.nodes[n][0], out);
        writeSolidReal(mesh.nodes[n][1], out);
        out << "*\n*       ";
        writeSolidReal(mesh.nodes[n][2], out);
        out << '\n';
    }
    std::uint64_t number = 0;
    for (const SolidCell &cell : mesh.cells) {
        writeSolidCard(cell.count == 6 ? "CPENTA  " : "CHEXA   ", ++number, groups.of(2, cell.region).number,
                       cell.nodes(), out);
    }
    for (const SolidFace &face : mesh.faces) {
        writeSolidCard(face.count == 3 ? "CTRIA3  " : "CQUAD4  ", ++number, groups.of(1, face.tag).number, face.nodes(),
                       out);
    }
    out << "ENDDATA\n";
}

} // namespace forefront
