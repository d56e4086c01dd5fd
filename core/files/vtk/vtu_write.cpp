#include "core/files/common/names.hpp"
#include "core/files/vtk/vtk.hpp"
#include "core/files/vtk/vtk_cells.hpp"

#include <bit>

namespace forefront {

namespace {

static_assert(std::endian::native == std::endian::little, "VTU files are written in the byte order of the machine");

std::string xmlEscaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        default:
            result += c;
        }
    }
    return result;
}

/// Writes the headers of the arrays in the appended data, then the arrays in the same order.
class AppendedArrays {
  public:
    explicit AppendedArrays(TextWriter &out) : out_(out) {}

    void announce(const char *type, const char *name, std::size_t components, std::size_t bytes) {
        out_ << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\"" << components
             << "\" format=\"appended\" offset=\"" << offset_ << "\"/>\n";
        offset_ += bytes + sizeof(std::uint64_t);
        sizes_.push_back(bytes);
    }
    /// Writes the length in front of the next array.
    void begin() { put(static_cast<std::uint64_t>(sizes_[next_++])); }
    template <class T>
    void put(T value) {
        out_.bytes(&value, sizeof value);
    }

  private:
    TextWriter &out_;
    std::size_t offset_ = 0, next_ = 0;
    std::vector<std::size_t> sizes_;
};

void writeData(const TriMesh &mesh, AppendedArrays &arrays, const TextWriter &out) {
    arrays.begin();
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        arrays.put(mesh.nodes[n].x);
        arrays.put(mesh.nodes[n].y);
        arrays.put(0.0);
    }
    const auto column = [&](auto triangle, auto edge, auto point) {
        arrays.begin();
        for (std::size_t e = 0; e < mesh.elements.size() && out.ok(); ++e) {
            triangle(e);
        }
        for (const TaggedEdge &item : mesh.edges) {
            edge(item);
        }
        for (const TaggedNode &item : mesh.points) {
            point(item);
        }
    };
    const auto put = [&](auto value) { arrays.put(value); };
    const auto node = [&](NodeId id) { put(static_cast<std::int32_t>(index(id))); };
    column([&](std::size_t e) { node(mesh.elements[e][0]), node(mesh.elements[e][1]), node(mesh.elements[e][2]); },
           [&](const TaggedEdge &edge) { node(edge.a), node(edge.b); },
           [&](const TaggedNode &point) { node(point.node); });
    std::int32_t end = 0;
    column([&](std::size_t) { put(end += 3); }, [&](const TaggedEdge &) { put(end += 2); },
           [&](const TaggedNode &) { put(end += 1); });
    column([&](std::size_t) { put(kVtkTriangle); }, [&](const TaggedEdge &) { put(kVtkLine); },
           [&](const TaggedNode &) { put(kVtkVertex); });
    column([&](std::size_t e) { put(mesh.region(e)); }, [&](const TaggedEdge &) { put(std::int32_t{0}); },
           [&](const TaggedNode &) { put(std::int32_t{0}); });
    column([&](std::size_t) { put(std::int32_t{0}); }, [&](const TaggedEdge &edge) { put(edge.tag); },
           [&](const TaggedNode &point) { put(point.tag); });
}

} // namespace

/// Writes VTU with raw appended data, which is compact and exact.
void writeVtu(const TriMesh &mesh, TextWriter &out) {
    const std::size_t cells = mesh.elements.size() + mesh.edges.size() + mesh.points.size();
    const std::size_t corners = 3 * mesh.elements.size() + 2 * mesh.edges.size() + mesh.points.size();
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
    out << "</CellData>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
    writeData(mesh, arrays, out);
    out << "\n</AppendedData>\n</VTKFile>\n";
}

} // namespace forefront
