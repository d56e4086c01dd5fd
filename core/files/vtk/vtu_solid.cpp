#include "core/files/common/solid_mesh.hpp"
#include "core/files/vtk/vtk.hpp"
#include "core/files/vtk/vtu_arrays.hpp"

#include <array>
#include <map>
#include <span>
#include <string>

namespace forefront {

namespace {

constexpr std::uint8_t kVtkTriangleFace = 5, kVtkQuad = 9, kVtkHexahedron = 12, kVtkWedge = 13;

/// The order of the corners of a prism: VTK's first triangle has its normal outwards, as the right-hand rule has it.
constexpr std::array<std::uint8_t, 6> kWedgeOrder = {0, 2, 1, 3, 5, 4};

/// Writes the headers of the field arrays with the tags of each name.
void writeSolidNames(const TagList &tags, TextWriter &out) {
    std::map<std::string, std::vector<std::int32_t>> fields;
    for (const auto &[tag, name] : tags.edges) {
        fields["boundary:" + validUtf8(name)].push_back(tag);
    }
    for (const auto &[tag, name] : tags.regions) {
        fields["region:" + validUtf8(name)].push_back(tag);
    }
    for (const auto &[name, numbers] : fields) {
        out << "<DataArray type=\"Int32\" Name=\"" << xmlEscaped(name) << "\" NumberOfTuples=\"" << numbers.size()
            << "\" format=\"ascii\">";
        for (const std::int32_t tag : numbers) {
            out << tag << ' ';
        }
        out << "</DataArray>\n";
    }
}

void writeSolidData(const SolidMesh &mesh, AppendedArrays &arrays) {
    arrays.begin();
    for (const std::array<double, 3> &node : mesh.nodes) {
        for (const double place : node) {
            arrays.put(place);
        }
    }
    const auto column = [&](auto cell, auto face) {
        arrays.begin();
        for (const SolidCell &each : mesh.cells) {
            cell(each);
        }
        for (const SolidFace &each : mesh.faces) {
            face(each);
        }
    };
    const auto put = [&](auto value) { arrays.put(value); };
    column(
        [&](const SolidCell &cell) {
            for (std::size_t k = 0; k < cell.count; ++k) {
                put(static_cast<std::int32_t>(cell.corners[cell.count == 6 ? kWedgeOrder[k] : k]));
            }
        },
        [&](const SolidFace &face) {
            for (const std::uint32_t node : face.nodes()) {
                put(static_cast<std::int32_t>(node));
            }
        });
    std::int32_t end = 0;
    column([&](const SolidCell &cell) { put(end += cell.count); },
           [&](const SolidFace &face) { put(end += face.count); });
    column([&](const SolidCell &cell) { put(cell.count == 6 ? kVtkWedge : kVtkHexahedron); },
           [&](const SolidFace &face) { put(face.count == 3 ? kVtkTriangleFace : kVtkQuad); });
    column([&](const SolidCell &cell) { put(cell.region); }, [&](const SolidFace &) { put(std::int32_t{0}); });
    column([&](const SolidCell &) { put(std::int32_t{0}); }, [&](const SolidFace &face) { put(face.tag); });
}

} // namespace

/// Writes prisms, hexahedra and faces as VTU with raw appended data, in the arrays and with the names of writeVtu().
void writeVtuSolid(const SolidMesh &mesh, TextWriter &out) {
    const std::size_t cells = mesh.cells.size() + mesh.faces.size();
    std::size_t corners = 0;
    for (const SolidCell &cell : mesh.cells) {
        corners += cell.count;
    }
    for (const SolidFace &face : mesh.faces) {
        corners += face.count;
    }
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
           "header_type=\"UInt64\">\n<UnstructuredGrid>\n<FieldData>\n";
    writeSolidNames(mesh.tags, out);
    out << "</FieldData>\n<Piece NumberOfPoints=\"" << mesh.nodes.size() << "\" NumberOfCells=\"" << cells << "\">\n";
    AppendedArrays arrays(out);
    constexpr std::size_t kInt = sizeof(std::int32_t);
    out << "<Points>\n";
    arrays.announce("Float64", "Points", 3, 3 * sizeof(double) * mesh.nodes.size());
    out << "</Points>\n<Cells>\n";
    arrays.announce("Int32", "connectivity", 1, kInt * corners);
    arrays.announce("Int32", "offsets", 1, kInt * cells);
    arrays.announce("UInt8", "types", 1, cells);
    out << "</Cells>\n<CellData Scalars=\"region\">\n";
    arrays.announce("Int32", "region", 1, kInt * cells);
    arrays.announce("Int32", "boundary", 1, kInt * cells);
    out << "</CellData>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
    writeSolidData(mesh, arrays);
    out << "\n</AppendedData>\n</VTKFile>\n";
}

} // namespace forefront
