#include "core/files/common/names.hpp"
#include "core/files/common/tagged_cells.hpp"
#include "core/files/common/vtk_cells.hpp"
#include "core/files/vtk/vtk.hpp"
#include "core/files/vtk/vtu_arrays.hpp"

#include <span>

namespace forefront {

namespace {

void writeData(const MeshView &mesh, AppendedArrays &arrays, const TextWriter &out) {
    arrays.begin();
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        arrays.put(mesh.nodes[n].x);
        arrays.put(mesh.nodes[n].y);
        arrays.put(0.0);
    }
    const auto column = [&](auto element, auto edge, auto point) {
        arrays.begin();
        for (const MeshView::Block &block : mesh.blocks()) {
            for (std::size_t k = 0; k < block.size() && out.ok(); ++k) {
                element(block, k);
            }
        }
        for (const TaggedEdge &item : mesh.edges) {
            edge(item);
        }
        for (const TaggedNode &item : mesh.points) {
            point(item);
        }
    };
    using Block = MeshView::Block;
    const auto put = [&](auto value) { arrays.put(value); };
    const auto putNodes = [&](const auto &nodes) {
        for (const NodeId node : nodes) {
            put(static_cast<std::int32_t>(index(node)));
        }
    };
    column([&](const Block &block, std::size_t k) { putNodes(block.nodesOf(k)); },
           [&](const TaggedEdge &edge) { putNodes(EdgeNodes(edge)); },
           [&](const TaggedNode &point) { putNodes(std::span(&point.node, 1)); });
    std::int32_t end = 0;
    column([&](const Block &block, std::size_t) { put(end += block.traits().nodes); },
           [&](const TaggedEdge &edge) { put(end += static_cast<std::int32_t>(EdgeNodes(edge).size())); },
           [&](const TaggedNode &) { put(end += 1); });
    const auto putType = [&](CellKind kind) { put(static_cast<std::uint8_t>(traitsOf(kind).vtk)); };
    column([&](const Block &block, std::size_t) { putType(block.kind); },
           [&](const TaggedEdge &edge) { putType(cellKindOf(edge)); },
           [&](const TaggedNode &) { putType(CellKind::Point); });
    column([&](const Block &block, std::size_t k) { put(block.region(k)); },
           [&](const TaggedEdge &) { put(std::int32_t{0}); }, [&](const TaggedNode &) { put(std::int32_t{0}); });
    column([&](const Block &, std::size_t) { put(std::int32_t{0}); }, [&](const TaggedEdge &edge) { put(edge.tag); },
           [&](const TaggedNode &point) { put(point.tag); });
    if (!mesh.elevations.empty()) {
        arrays.begin();
        for (const double elevation : mesh.elevations) {
            put(elevation);
        }
    }
}

} // namespace

/// Writes VTU with raw appended data, which is compact and exact.
void writeVtu(const MeshView &mesh, TextWriter &out) {
    const std::size_t cells = mesh.elementCount() + mesh.edges.size() + mesh.points.size();
    const std::size_t corners = nodesOfElements(mesh) + nodesOfEdges(mesh) + mesh.points.size();
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
           "header_type=\"UInt64\">\n<UnstructuredGrid>\n<FieldData>\n";
    for (const auto &[name, tags] : vtkNameFields(mesh)) {
        out << "<DataArray type=\"Int32\" Name=\"" << xmlEscaped(name) << "\" NumberOfTuples=\"" << tags.size()
            << "\" format=\"ascii\">";
        for (const std::int32_t tag : tags) {
            out << tag << ' ';
        }
        out << "</DataArray>\n";
    }
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
    out << "</CellData>\n";
    if (!mesh.elevations.empty()) {
        out << "<PointData>\n";
        arrays.announce("Float64", "elevation", 1, sizeof(double) * mesh.nodes.size());
        out << "</PointData>\n";
    }
    out << "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
    writeData(mesh, arrays, out);
    out << "\n</AppendedData>\n</VTKFile>\n";
}

} // namespace forefront
