#include "core/files/mfem/mfem.hpp"

#include "core/files/common/names.hpp"
#include "core/files/common/planar_mesh.hpp"
#include "core/files/common/raise_tags.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace forefront {

namespace {

/// The kinds of cells by their numbers in MFEM.
constexpr std::array kMfemKinds = {CellKind::Point, CellKind::Edge2, CellKind::Triangle3, CellKind::Quadrilateral4};

void writeMfemCell(std::int32_t attribute, std::size_t kind, std::span<const NodeId> nodes, TextWriter &out) {
    out << attribute << ' ' << kind;
    for (const NodeId node : nodes) {
        out << ' ' << index(node);
    }
    out << '\n';
}

} // namespace

/// Writes elements with their region and boundary edges with their part as attributes. Comments between the header and
/// the first section keep names and points.
void writeMfem(const MeshView &mesh, TextWriter &out) {
    out << "MFEM mesh v1.0\n\n";
    writeNameComments(mesh, "#", out);
    for (const TaggedNode &point : mesh.points) {
        out << "# point " << index(point.node) << ' ' << point.tag << '\n';
    }
    out << "\ndimension\n2\n\nelements\n" << mesh.elementCount() << '\n';
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size() && out.ok(); ++k) {
            writeMfemCell(block.region(k), block.kind == CellKind::Triangle3 ? 2 : 3, block.nodesOf(k), out);
        }
    }
    out << "\nboundary\n" << mesh.edges.size() << '\n';
    for (const TaggedEdge &edge : mesh.edges) {
        const NodeId ends[] = {edge.a, edge.b};
        writeMfemCell(edge.tag, 1, ends, out);
    }
    out << "\nvertices\n" << mesh.nodes.size() << "\n2\n";
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << mesh.nodes[n].x << ' ' << mesh.nodes[n].y << '\n';
    }
}

namespace {

/// Reads sections in the order of MFEM. The vertices come last, so elements and boundary are read again after them.
class MfemReader {
  public:
    explicit MfemReader(const SourceText &source) : scanner_(source, '#') {}

    Result<Mesh> read() {
        if (!header() || !skipSections() || !vertices()) {
            return scanner_.faults();
        }
        scanner_.seek(elementsAt_);
        if (!cells("element") || !scanner_.literal("boundary") || !cells("boundary element")) {
            return scanner_.faults();
        }
        scanner_.source().numbered(PartNumbers(0), builder_.elements.numberedFrom(0));
        builder_.readPointComments(scanner_, "#");
        Mesh mesh = builder_.finish();
        TagNames names = readNameComments(scanner_.source().text, "#");
        mesh.boundaryNames = std::move(names.boundary);
        mesh.regionNames = std::move(names.region);
        raiseTags(mesh, scanner_.source());
        return mesh;
    }

  private:
    bool header() {
        const std::size_t place = scanner_.offset();
        const std::string_view text = scanner_.source().text;
        const std::string_view line = text.substr(0, text.find('\n'));
        if (!line.starts_with("MFEM mesh v1.0") && !line.starts_with("MFEM mesh v1.2")) {
            return scanner_.fail(place, "unknown-version",
                                 "expected MFEM mesh v1.0 or v1.2, found " + inQuotes(line.substr(0, 40)),
                                 "save it from MFEM as a mesh without curvature, refinement or NURBS");
        }
        scanner_.skipLine();
        std::int64_t dimension = 0;
        return scanner_.literal("dimension") && scanner_.integer(dimension, 2, 2, {"the dimension"});
    }

    /// Skips elements and boundary, whose vertices are not known yet.
    bool skipSections() {
        if (!scanner_.literal("elements")) {
            return false;
        }
        elementsAt_ = scanner_.offset();
        return skipItems() && scanner_.literal("boundary") && skipItems();
    }

    bool skipItems() {
        std::size_t count = 0;
        if (!scanner_.count(count, 6, {"the number of items"})) {
            return false;
        }
        scanner_.skipLine();
        TextScanner line = scanner_;
        for (std::size_t k = 0; k < count; ++k) {
            if (!scanner_.nextLine(line)) {
                return scanner_.ok() && scanner_.fail(scanner_.offset(), "bad-count",
                                                      "the section has " + std::to_string(k) + " lines instead of " +
                                                          std::to_string(count));
            }
        }
        return true;
    }

    bool vertices() {
        std::size_t count = 0;
        if (!scanner_.literal("vertices") || !scanner_.count(count, 2, {"the number of vertices"})) {
            return false;
        }
        std::int64_t dimension = 2;
        if (scanner_.peek() == "nodes") {
            return refuseNodes();
        }
        if (!scanner_.integer(dimension, 2, 3, {"the number of coordinates"})) {
            return false;
        }
        for (std::size_t k = 0; k < count; ++k) {
            if (!builder_.readNode(scanner_, static_cast<std::int64_t>(k), static_cast<int>(dimension))) {
                return false;
            }
        }
        if (scanner_.peek() == "nodes") {
            return refuseNodes();
        }
        if (scanner_.ok() && !scanner_.atEnd() && scanner_.peek() != "mfem_mesh_end") {
            scanner_.source().note("section", "section " + inQuotes(scanner_.peek()) + " and the rest are ignored",
                                   scanner_.offset());
        }
        return builder_.finishNodes(scanner_);
    }

    bool refuseNodes() {
        return scanner_.fail(scanner_.offset(), "unknown-element", "meshes with curved edges (nodes) cannot be read",
                             "save it from MFEM without curvature");
    }

    bool cells(const char *what) {
        std::size_t count = 0;
        const bool boundary = std::string_view(what) != "element";
        if (!scanner_.count(count, 6, {"the number of items"})) {
            return false;
        }
        for (std::size_t k = 0; k < count; ++k) {
            std::int32_t attribute = 1;
            std::int64_t number = 0;
            const Expect expect{what, k};
            if (!readTag(scanner_, attribute, expect)) {
                return false;
            }
            scanner_.peek();
            const std::size_t place = scanner_.offset();
            if (!scanner_.integer(number, 0, 100, expect)) {
                return false;
            }
            const bool known = boundary ? number == 1 : number == 2 || number == 3;
            if (!known) {
                return scanner_.fail(place, "unknown-element",
                                     expect.words() + " is of geometry " + std::to_string(number) +
                                         "; only triangles (2) and squares (3), with segments (1) on the boundary");
            }
            const CellKind kind = kMfemKinds[static_cast<std::size_t>(number)];
            if (!(boundary ? builder_.readEdge(scanner_, kind, attribute, expect)
                           : builder_.readElement(scanner_, kind, attribute, expect))) {
                return false;
            }
        }
        return true;
    }

    TextScanner scanner_;
    PlanarMeshBuilder builder_;
    std::size_t elementsAt_ = 0;
};

} // namespace

bool looksLikeMfem(std::string_view head) {
    return head.starts_with("MFEM ");
}

Result<Mesh> readMfem(const SourceText &source) {
    return MfemReader(source).read();
}

} // namespace forefront
