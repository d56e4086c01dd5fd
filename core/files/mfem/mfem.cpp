#include "core/files/mfem/mfem.hpp"

#include "core/files/common/names.hpp"
#include "core/files/common/planar_mesh.hpp"
#include "core/files/common/raise_tags.hpp"
#include "core/files/mfem/mfem_nodes.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// The kinds of cells by their numbers in MFEM.
constexpr std::array kMfemKinds = {CellKind::Point, CellKind::Edge2, CellKind::Triangle3, CellKind::Quadrilateral4};

/// Marks a mesh whose quadrilaterals have 8 nodes here; MFEM always gives them 9.
constexpr std::string_view kEightNodes = "# quadrilaterals of 8 nodes";

/// The head of nodes of second order, one place after the other.
constexpr const char *kNodesHead =
    "nodes\nFiniteElementSpace\nFiniteElementCollection: H1_2D_P2\nVDim: 2\nOrdering: 1\n\n";

/// The vertices of a mesh: all nodes in a mesh of first order, else the corners of elements.
struct MfemVertices {
    std::optional<MfemNodes> curved;

    std::uint32_t of(NodeId node) const {
        return curved ? curved->vertexOf[index(node)] : static_cast<std::uint32_t>(index(node));
    }
};

void writeMfemCell(std::int32_t attribute, std::size_t kind, std::span<const NodeId> corners,
                   const MfemVertices &vertices, TextWriter &out) {
    out << attribute << ' ' << kind;
    for (const NodeId node : corners) {
        out << ' ' << vertices.of(node);
    }
    out << '\n';
}

void writeMfemComments(const MeshView &mesh, const MfemVertices &vertices, TextWriter &out) {
    writeNameComments(mesh, "#", out);
    for (const TaggedNode &point : mesh.points) {
        if (vertices.of(point.node) != kNoIndex) {
            out << "# point " << vertices.of(point.node) << ' ' << point.tag << '\n';
        }
    }
    const auto has = [&](CellKind kind) {
        return std::ranges::any_of(mesh.blocks(), [kind](const auto &block) { return block.kind == kind; });
    };
    if (has(CellKind::Quadrilateral8) && !has(CellKind::Quadrilateral9)) {
        out << kEightNodes << '\n';
    }
}

void writePlaces(std::span<const Vec2> places, TextWriter &out) {
    for (std::size_t n = 0; n < places.size() && out.ok(); ++n) {
        out << places[n].x << ' ' << places[n].y << '\n';
    }
}

} // namespace

/// Writes elements with their region and boundary edges with their part as attributes. Comments between the header and
/// the first section keep names and points.
void writeMfem(const MeshView &mesh, TextWriter &out) {
    MfemVertices vertices;
    if (mesh.hasSecondOrder()) {
        vertices.curved = mfemNodes(mesh);
    }
    out << "MFEM mesh v1.0\n\n";
    writeMfemComments(mesh, vertices, out);
    out << "\ndimension\n2\n\nelements\n" << mesh.elementCount() << '\n';
    for (const MeshView::Block &block : mesh.blocks()) {
        const std::size_t corners = block.traits().corners;
        for (std::size_t k = 0; k < block.size() && out.ok(); ++k) {
            writeMfemCell(block.region(k), corners - 1, block.nodesOf(k).first(corners), vertices, out);
        }
    }
    out << "\nboundary\n" << mesh.edges.size() << '\n';
    for (const TaggedEdge &edge : mesh.edges) {
        const NodeId ends[] = {edge.a, edge.b};
        writeMfemCell(edge.tag, 1, ends, vertices, out);
    }
    out << "\nvertices\n";
    if (vertices.curved) {
        out << vertices.curved->vertices << "\n\n" << kNodesHead;
        writePlaces(vertices.curved->places, out);
    } else {
        out << mesh.nodes.size() << "\n2\n";
        writePlaces(mesh.nodes, out);
    }
}

namespace {

/// A grid function of MFEM: the places of nodes.
struct MfemGridFunction {
    std::size_t begins = 0; ///< byte of the source
    std::size_t order = 0;  ///< 1 or 2
    std::vector<Vec2> places;
};

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
        if (curves_.order == 2 && !curve()) {
            return scanner_.faults();
        }
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
                                 "save it from MFEM as a mesh without refinement, NURBS and sets of attributes");
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
            return gridFunction(count) && builder_.finishNodes(scanner_);
        }
        if (!scanner_.integer(dimension, 2, 3, {"the number of coordinates"})) {
            return false;
        }
        for (std::size_t k = 0; k < count; ++k) {
            if (!builder_.readNode(scanner_, static_cast<std::int64_t>(k), static_cast<int>(dimension))) {
                return false;
            }
        }
        if (scanner_.ok() && !scanner_.atEnd() && scanner_.peek() != "mfem_mesh_end") {
            scanner_.source().note("section", "section " + inQuotes(scanner_.peek()) + " and the rest are ignored",
                                   scanner_.offset());
        }
        return builder_.finishNodes(scanner_);
    }

    /// Reads the places of `vertices` vertices, and of the middles of edges and quadrilaterals, which are kept.
    bool gridFunction(std::size_t vertices) {
        curves_.begins = scanner_.offset();
        std::int64_t dimension = 2, ordering = 1;
        if (!scanner_.literal("nodes") || !scanner_.literal("FiniteElementSpace") || !collection() ||
            !scanner_.literal("VDim:") || !scanner_.integer(dimension, 2, 3, {"the number of coordinates"}) ||
            !scanner_.literal("Ordering:") || !scanner_.integer(ordering, 0, 1, {"the order of coordinates"})) {
            return false;
        }
        std::vector<double> values;
        while (!scanner_.atEnd() && scanner_.peek() != "mfem_mesh_end") {
            double value = 0.0;
            if (!scanner_.real(value, {"the coordinates of nodes"})) {
                return false;
            }
            values.push_back(value);
        }
        const std::size_t places = values.size() / static_cast<std::size_t>(dimension);
        if (values.size() % static_cast<std::size_t>(dimension) != 0 || places < vertices ||
            (curves_.order == 1 && places != vertices)) {
            return wrongCount(places, vertices);
        }
        for (std::size_t k = 0; k < places; ++k) {
            const auto value = [&](std::size_t axis) {
                return values[ordering == 1 ? k * static_cast<std::size_t>(dimension) + axis : axis * places + k];
            };
            curves_.places.push_back({value(0), value(1)});
            builder_.noteHeight(dimension == 3 ? value(2) : 0.0, curves_.begins);
        }
        for (std::size_t k = 0; k < vertices; ++k) {
            builder_.mesh.nodes.push_back(curves_.places[k]);
            builder_.table.add(static_cast<std::int64_t>(k));
        }
        return scanner_.ok();
    }

    bool collection() {
        if (!scanner_.literal("FiniteElementCollection:")) {
            return false;
        }
        scanner_.peek();
        const std::size_t place = scanner_.offset();
        const std::string_view name = scanner_.word();
        if (name == "H1_2D_P2" || name == "Quadratic") {
            curves_.order = 2;
        } else if (name == "H1_2D_P1" || name == "Linear") {
            curves_.order = 1;
        } else {
            return scanner_.fail(place, "unknown-element",
                                 "nodes of " + inQuotes(name.substr(0, 40)) + " cannot be read, only those of H1_2D_P2",
                                 "save it from MFEM after mesh.SetCurvature(2, false)");
        }
        return true;
    }

    bool wrongCount(std::size_t found, std::size_t expected) {
        return scanner_.fail(curves_.begins, "bad-count",
                             "the grid function has " + std::to_string(found) + " places; the elements need " +
                                 std::to_string(expected));
    }

    /// Gives the elements and edges their middle nodes.
    bool curve() {
        const bool eight = scanner_.source().text.substr(0, elementsAt_).find(kEightNodes) != std::string_view::npos;
        const std::size_t vertices = builder_.mesh.nodes.size();
        std::size_t expected = 0;
        ElementList curved =
            curvedElements(builder_.elements, vertices, curves_.places, eight ? 8 : 9, builder_.mesh.nodes, expected);
        if (expected != curves_.places.size()) {
            return wrongCount(curves_.places.size(), expected);
        }
        builder_.elements = std::move(curved);
        builder_.findMiddles();
        return true;
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
    MfemGridFunction curves_; ///< of order 0 in a mesh with straight edges
};

} // namespace

bool looksLikeMfem(std::string_view head) {
    return head.starts_with("MFEM ");
}

Result<Mesh> readMfem(const SourceText &source) {
    return MfemReader(source).read();
}

} // namespace forefront
