#include "core/files/medit/medit.hpp"

#include "core/files/common/names.hpp"
#include "core/files/common/planar_mesh.hpp"

#include <limits>

namespace forefront {

/// Writes MEDIT .mesh (the Gamma mesh format of INRIA), ASCII, in two dimensions. Comments hold the names. Gmsh expects
/// `Dimension` and its number on separate lines.
void writeMedit(const Mesh &mesh, TextWriter &out) {
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
    out << "\nEdges\n" << mesh.edges.size() << '\n';
    for (const TaggedEdge &edge : mesh.edges) {
        out << index(edge.a) + 1 << ' ' << index(edge.b) + 1 << ' ' << edge.tag << '\n';
    }
    out << "\nTriangles\n" << mesh.elements.size() << '\n';
    for (std::size_t e = 0; e < mesh.elements.size() && out.ok(); ++e) {
        for (const NodeId node : mesh.elements[e]) {
            out << index(node) + 1 << ' ';
        }
        out << mesh.region(e) << '\n';
    }
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
        for (TaggedNode &point : builder_.mesh.points) {
            point.tag = labels_[index(point.node)];
        }
        TagNames names = readNameComments(scanner_.source().text, "#");
        builder_.mesh.boundaryNames = std::move(names.boundary);
        builder_.mesh.regionNames = std::move(names.region);
        return builder_.finish();
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
        std::size_t count = 0;
        const std::size_t items = itemsOf(word);
        if (items == 0 || !verticesRead_) {
            return scanner_.fail(place, items == 0 ? "unknown-section" : "bad-syntax",
                                 items == 0 ? "the section " + inQuotes(word) + " cannot be read"
                                            : inQuotes(word) + " come before Vertices");
        }
        if (!scanner_.count(count, 2 * items, {"the number of items"})) {
            return false;
        }
        if (word != "Edges" && word != "Triangles" && word != "RequiredVertices") {
            scanner_.source().note("section", "section " + std::string(word) + " is ignored", place);
        }
        for (std::size_t k = 0; k < count; ++k) {
            if (!item(word, items, k + 1)) {
                return false;
            }
        }
        return true;
    }

    /// Returns the number of values per line of a section; 0: unknown, or not triangles.
    static std::size_t itemsOf(std::string_view word) {
        constexpr std::pair<std::string_view, std::size_t> kSections[] = {
            {"Edges", 3},    {"Triangles", 4},        {"RequiredVertices", 1},  {"Corners", 1},
            {"Ridges", 1},   {"RequiredEdges", 1},    {"RequiredTriangles", 1}, {"Normals", 3},
            {"Tangents", 3}, {"NormalAtVertices", 2}, {"TangentAtVertices", 2}};
        for (const auto &[name, items] : kSections) {
            if (name == word) {
                return items;
            }
        }
        return 0;
    }

    bool item(std::string_view word, std::size_t items, std::size_t number) {
        std::int32_t tag = 1;
        double unused = 0.0;
        if (word == "Triangles") {
            return builder_.readElement(scanner_, 1, {"triangle", number}) &&
                   readTag(scanner_, builder_.mesh.regions.back(), {"the reference of triangle", number});
        }
        if (word == "Edges") {
            return builder_.readEdge(scanner_, tag, {"edge", number}) &&
                   readTag(scanner_, builder_.mesh.edges.back().tag, {"the reference of edge", number});
        }
        if (word == "RequiredVertices") {
            return builder_.readPoint(scanner_, tag, {"required vertex", number});
        }
        for (std::size_t k = 0; k < items; ++k) {
            if (!scanner_.real(unused, {"item", number})) {
                return false;
            }
        }
        return true;
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
