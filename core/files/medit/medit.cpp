#include "core/files/medit/medit.hpp"

#include "core/files/common/names.hpp"
#include "core/files/common/node_labels.hpp"
#include "core/files/common/planar_mesh.hpp"
#include "core/files/common/raise_tags.hpp"
#include "core/files/common/tagged_cells.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>

namespace forefront {

namespace {

void writeMeditItem(std::span<const NodeId> nodes, std::int32_t tag, TextWriter &out) {
    for (const NodeId node : nodes) {
        out << index(node) + 1 << ' ';
    }
    out << tag << '\n';
}

/// Writes a section for each kind of edges that the mesh has; an empty one if it has no edges.
void writeEdgeSections(const MeshView &mesh, TextWriter &out) {
    for (const CellKind kind : {CellKind::Edge2, CellKind::Edge3}) {
        const auto count = std::count_if(mesh.edges.begin(), mesh.edges.end(),
                                         [kind](const TaggedEdge &edge) { return cellKindOf(edge) == kind; });
        if (count == 0 && (kind == CellKind::Edge3 || !mesh.edges.empty())) {
            continue;
        }
        out << '\n' << traitsOf(kind).medit << '\n' << count << '\n';
        for (const TaggedEdge &edge : mesh.edges) {
            if (cellKindOf(edge) == kind) {
                writeMeditItem(EdgeNodes(edge), edge.tag, out);
            }
        }
    }
}

/// Writes a section for each kind of elements that the mesh has; an empty one if it has no elements. Readers expect a
/// section at most once.
void writeElementSections(const MeshView &mesh, TextWriter &out) {
    for (const CellKind kind : kElementKinds) {
        std::size_t count = 0;
        for (const MeshView::Block &block : mesh.blocks()) {
            count += block.kind == kind ? block.size() : 0;
        }
        if (count == 0 && (kind != CellKind::Triangle3 || mesh.elementCount() > 0)) {
            continue;
        }
        out << '\n' << traitsOf(kind).medit << '\n' << count << '\n';
        for (const MeshView::Block &block : mesh.blocks()) {
            for (std::size_t k = 0; block.kind == kind && k < block.size() && out.ok(); ++k) {
                writeMeditItem(block.nodesOf(k), block.region(k), out);
            }
        }
    }
}

} // namespace

/// Writes MEDIT .mesh (the Gamma mesh format of INRIA), ASCII, in two dimensions. Comments hold the names. Gmsh expects
/// `Dimension` and its number on separate lines.
void writeMedit(const MeshView &mesh, TextWriter &out) {
    out << "MeshVersionFormatted 2\n";
    writeNameComments(mesh, "#", out);
    out << "Dimension\n2\n\nVertices\n" << mesh.nodes.size() << '\n';
    // Gmsh takes a vertex label for z in plane files, so only constraint points have one; edges carry the boundary
    // tags.
    std::vector<std::int32_t> labels(mesh.nodes.size(), 0);
    for (const TaggedNode &point : mesh.points) {
        labels[index(point.node)] = point.tag;
    }
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << mesh.nodes[n].x << ' ' << mesh.nodes[n].y << ' ' << labels[n] << '\n';
    }
    writeEdgeSections(mesh, out);
    writeElementSections(mesh, out);
    if (!mesh.points.empty()) {
        out << "\nRequiredVertices\n" << mesh.points.size() << '\n';
        for (const TaggedNode &point : mesh.points) {
            out << index(point.node) + 1 << '\n';
        }
    }
    out << "\nEnd\n";
}

namespace {

class MeditReader {
  public:
    explicit MeditReader(const SourceText &source) : scanner_(source, '#') {}

    Result<Mesh> read() {
        while (scanner_.ok() && !scanner_.atEnd()) {
            const std::size_t place = scanner_.offset();
            const std::string_view word = scanner_.word();
            if (word == "End") {
                break;
            }
            section(word, place);
        }
        if (scanner_.ok() && !verticesRead_) {
            scanner_.fail(scanner_.offset(), "bad-syntax", "the file has no Vertices");
        }
        if (!scanner_.ok()) {
            return scanner_.faults();
        }
        scanner_.source().numbered(PartNumbers(1), builder_.elements.numberedFrom(1));
        Mesh mesh = builder_.finish();
        for (TaggedNode &point : mesh.points) {
            point.tag = labels_[index(point.node)];
        }
        TagNames names = readNameComments(scanner_.source().text, "#");
        mesh.boundaryNames = std::move(names.boundary);
        mesh.regionNames = std::move(names.region);
        noteUnusedLabels(labels_, mesh, "vertex-references", scanner_.source());
        raiseTags(mesh, scanner_.source());
        return mesh;
    }

  private:
    bool section(std::string_view word, std::size_t place) {
        std::int64_t number = 0;
        if (word == "MeshVersionFormatted") {
            return scanner_.integer(number, 0, 4, {"the version"}); // bamg writes 0
        }
        if (word == "Dimension") {
            const bool done = scanner_.integer(number, 2, 3, {"the dimension"});
            dimension_ = static_cast<int>(number);
            return done;
        }
        if (word == "Vertices" && !verticesRead_) {
            return vertices();
        }
        const std::optional<CellKind> kind = cellsOf(word);
        const bool used = kind || word == "RequiredVertices";
        if (used && !verticesRead_) {
            return scanner_.fail(place, "bad-syntax", inQuotes(word) + " come before Vertices");
        }
        if (!used) {
            return otherSection(word, place);
        }
        std::size_t count = 0;
        if (!scanner_.count(count, word == "RequiredVertices" ? 2 : 6, {"the number of items"})) {
            return false;
        }
        scanner_.peek();
        const std::size_t items = scanner_.offset();
        for (std::size_t k = 0; k < count; ++k) {
            if (!item(kind, k + 1)) {
                return kind && count > 0 && refuseOfSecondOrder(word, *kind, items);
            }
        }
        const std::string_view next = scanner_.atEnd() ? std::string_view("End") : scanner_.peek();
        const bool numbers = next.front() >= '0' && next.front() <= '9';
        return !kind || count == 0 || !numbers || !hasSecondOrder(*kind, items) ||
               refuseOfSecondOrder(word, *kind, items);
    }

    /// Returns the number of words on the line at a place.
    std::size_t wordsOnLine(std::size_t place) const {
        const std::string_view text = scanner_.source().text;
        TextScanner line = scanner_.part(place, std::min(text.find('\n', place), text.size()));
        std::size_t words = 0;
        for (; !line.atEnd(); ++words) {
            line.word();
        }
        return words;
    }

    /// Returns true if the line of an item has the nodes of a kind of second order, and a reference.
    bool hasSecondOrder(CellKind kind, std::size_t place) const {
        const std::size_t words = wordsOnLine(place);
        const auto kinds = valuesOf<CellKind>();
        return traitsOf(kind).order == 1 && std::any_of(kinds.begin(), kinds.end(), [&](CellKind other) {
                   const CellTraits &traits = traitsOf(other);
                   return traits.order == 2 && traits.corners == traitsOf(kind).corners &&
                          traits.dimension == traitsOf(kind).dimension && words == traits.nodes + 1U;
               });
    }

    /// Refuses a section of elements that Gmsh has written under the keyword of the first order; returns false.
    bool refuseOfSecondOrder(std::string_view word, CellKind kind, std::size_t place) {
        if (!hasSecondOrder(kind, place)) {
            return false; // refused for another reason
        }
        const std::string keyword(word);
        scanner_ = TextScanner(scanner_.source(), '#');
        return scanner_.fail(place, "unknown-element",
                             "the section " + inQuotes(keyword) + " holds elements of second order, with " +
                                 std::to_string(wordsOnLine(place) - 1) + " nodes on a line instead of " +
                                 std::to_string(traitsOf(kind).nodes) + ", as Gmsh writes them",
                             "save it from gmsh as .msh or .vtk instead");
    }

    /// Returns the kind of cells in a section.
    static std::optional<CellKind> cellsOf(std::string_view word) {
        for (const CellKind kind : valuesOf<CellKind>()) {
            if (traitsOf(kind).medit != nullptr && word == traitsOf(kind).medit) {
                return kind;
            }
        }
        return std::nullopt;
    }

    /// Returns true for sections of elements of other kinds, such as TrianglesP3.
    static bool holdsOtherElements(std::string_view word) {
        constexpr std::array kOthers = {"Quadrilaterals", "Tetrahedra", "Hexahedra", "Prisms",
                                        "Pentahedra",     "Pyramids",   "Polygons",  "Polyhedra"};
        const std::string_view base = word.substr(0, word.find_last_not_of("PQ0123456789") + 1);
        return std::find(kOthers.begin(), kOthers.end(), base) != kOthers.end() ||
               (base != word && (base == "Edges" || base == "Triangles"));
    }

    /// Skips a section that is not used up to the next one, which begins with a letter, and notes it unless it is
    /// empty. Programs add sections of their own, such as those of bamg about the geometry.
    bool otherSection(std::string_view word, std::size_t place) {
        const auto isLetter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
        if (!isLetter(word.front()) || word == "Vertices") {
            return scanner_.fail(place, "unknown-section",
                                 word == "Vertices" ? "a second section Vertices cannot be read"
                                                    : "expected a section such as Triangles, found " + inQuotes(word));
        }
        const std::string first(scanner_.peek());
        if (holdsOtherElements(word) && first != "0") {
            return scanner_.fail(place, "unknown-element",
                                 "the section " + inQuotes(word) + " cannot be read; only " + kReadableCells +
                                     " can be read");
        }
        while (!scanner_.atEnd() && !isLetter(scanner_.peek().front())) {
            std::string_view quoted;
            if (!scanner_.proceed(scanner_.offset()) || !scanner_.quotedWord(quoted, {"a value"})) {
                return false;
            }
        }
        if (first != "0") {
            scanner_.source().note("section", "section " + cleanName(word) + " is ignored", place);
        }
        return true;
    }

    /// Reads a cell of a kind and its reference, or a required vertex.
    bool item(std::optional<CellKind> kind, std::size_t number) {
        const std::int32_t tag = 1;
        if (!kind) {
            return builder_.readPoint(scanner_, tag, {"required vertex", number});
        }
        if (traitsOf(*kind).dimension == 1) {
            return builder_.readEdge(scanner_, *kind, tag, {"edge", number}) &&
                   readTag(scanner_, builder_.mesh.edges.back().tag, {"the reference of edge", number});
        }
        const bool triangle = traitsOf(*kind).corners == 3;
        return builder_.readElement(scanner_, *kind, tag, {triangle ? "triangle" : "quadrilateral", number}) &&
               readTag(scanner_, builder_.elements.regions.back(),
                       {triangle ? "the reference of triangle" : "the reference of quadrilateral", number});
    }

    bool vertices() {
        std::size_t count = 0;
        verticesRead_ = true;
        if (!scanner_.count(count, 6, {"the number of vertices"})) {
            return false;
        }
        builder_.reserveNodes(count);
        labels_.resize(count);
        for (std::size_t k = 0; k < count; ++k) {
            if (!builder_.readNode(scanner_, static_cast<std::int64_t>(k) + 1, dimension_) ||
                !readTag(scanner_, labels_[k], {"the reference of vertex", k + 1})) {
                return false;
            }
        }
        return builder_.finishNodes(scanner_);
    }

    TextScanner scanner_;
    PlanarMeshBuilder builder_;
    std::vector<std::int32_t> labels_;
    int dimension_ = 3;
    bool verticesRead_ = false;
};

} // namespace

bool looksLikeMedit(std::string_view head) {
    return head.find("MeshVersionFormatted") != std::string_view::npos;
}

Result<Mesh> readMedit(const SourceText &source) {
    return MeditReader(source).read();
}

} // namespace forefront
