#include "core/engine/base/hash.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/files/common/names.hpp"
#include "core/files/common/node_labels.hpp"
#include "core/files/common/planar_mesh.hpp"
#include "core/files/common/raise_tags.hpp"
#include "core/files/source/companion.hpp"
#include "core/files/text/atomic_file.hpp"
#include "core/files/triangle/triangle.hpp"
#include "core/files/triangle/triangle_nodes.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace forefront {

namespace {

/// Returns a text that differs between meshes, also if they differ in the numbers of their nodes alone.
std::string numberingOf(const MeshView &mesh) {
    Hash64 hash;
    for (const Vec2 node : mesh.nodes) {
        hash.add(node.x);
        hash.add(node.y);
    }
    for (const MeshView::Block &block : mesh.blocks()) {
        for (const NodeId node : block.connectivity) {
            hash.add(static_cast<std::uint64_t>(index(node)));
        }
    }
    return toHex(hash.value());
}

/// Begins the comment that names the mesh of a file.
constexpr std::string_view kMeshComment = "# mesh ";

/// Returns the name in the comment of a file; empty if it has none.
std::string_view meshOf(std::string_view text) {
    const std::size_t at = text.rfind(kMeshComment);
    if (at == std::string_view::npos || (at > 0 && text[at - 1] != '\n')) {
        return {};
    }
    const std::string_view line = text.substr(at + kMeshComment.size());
    return line.substr(0, line.find_first_of("\r\n"));
}

void writeNodes(const MeshView &mesh, TextWriter &out) {
    out << mesh.nodes.size() << " 2 0 1\n";
    const std::vector<std::int32_t> labels = nodeLabels(mesh);
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << n + 1 << ' ' << mesh.nodes[n].x << ' ' << mesh.nodes[n].y << ' ' << labels[n] << '\n';
    }
    writeNameComments(mesh, "#", out);
    for (const TaggedNode &point : mesh.points) {
        out << "# point " << index(point.node) + 1 << ' ' << point.tag << '\n';
    }
}

/// Writes triangles of 3 or of 6 nodes. The middle nodes of edges stand only here.
void writeElements(const MeshView &mesh, TextWriter &out) {
    const CellTraits &traits = mesh.elementCount() > 0 ? mesh.blocks().front().traits() : traitsOf(CellKind::Triangle3);
    out << mesh.elementCount() << ' ' << traits.nodes << " 1\n";
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size() && out.ok(); ++k) {
            out << block.first + k + 1;
            const std::span<const NodeId> nodes = block.nodesOf(k);
            for (std::size_t n = 0; n < nodes.size(); ++n) {
                out << ' ' << index(nodes[traits.opposite[n]]) + 1;
            }
            out << ' ' << block.region(k) << '\n';
        }
    }
}

void writeEdges(const MeshView &mesh, TextWriter &out) {
    out << mesh.edges.size() << " 1\n";
    for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
        const TaggedEdge &edge = mesh.edges[k];
        out << k + 1 << ' ' << index(edge.a) + 1 << ' ' << index(edge.b) + 1 << ' ' << edge.tag << '\n';
    }
}

} // namespace

/// Writes the files of J. R. Shewchuk's Triangle: nodes with markers, triangles with the region as attribute, the
/// tagged edges.
Status writeTriangle(FileSet &files, const std::filesystem::path &path, const MeshView &mesh, const ExportOptions &,
                     const Progress &progress) {
    using Write = void (*)(const MeshView &, TextWriter &);
    static constexpr std::array<Write, kTriangleExtensions.size()> kWrites{writeNodes, writeElements, writeEdges};
    const std::string id = numberingOf(mesh);
    for (std::size_t i = 0; i < kWrites.size(); ++i) {
        std::filesystem::path file = path;
        file.replace_extension(kTriangleExtensions[i]);
        const auto fill = [&](TextWriter &out) {
            kWrites[i](mesh, out);
            out << kMeshComment << id << '\n';
        };
        files.write(file, fill, progress, 1 + mesh.elementCount() * 32);
    }
    return files.status();
}

namespace {

class TriangleMeshReader {
  public:
    bool readNodes(const SourceText &source) {
        TextScanner scanner(source, '#');
        TriangleNodes nodes;
        if (!nodes.read(scanner, false)) {
            return fail(scanner);
        }
        if (!noMore(scanner, nodes.places.size(), "node")) {
            return false;
        }
        if (nodes.attributes > 0) {
            source.note("node-attributes", "attributes of nodes are ignored", 0, nodes.places.size());
        }
        labels_ = std::move(nodes.markers);
        std::replace(labels_.begin(), labels_.end(), 1, 0); // Triangle marks all nodes of an unmarked boundary with 1
        builder_.mesh.nodes = std::move(nodes.places);
        builder_.table = std::move(nodes.table);
        TagNames names = readNameComments(source.text, "#");
        builder_.mesh.boundaryNames = std::move(names.boundary);
        builder_.mesh.regionNames = std::move(names.region);
        for (std::size_t at = source.text.find("\n# point "); at != std::string_view::npos;
             at = source.text.find("\n# point ", at + 1)) {
            constexpr std::size_t kStart = 9;
            TextScanner comment(source);
            comment.seek(at + kStart);
            std::int64_t node = 0, tag = 0; // comments of other programs may begin like ours
            constexpr std::int64_t kGreatest = std::numeric_limits<std::int32_t>::max();
            if (comment.integer(node, 0, kGreatest, {"a point"}) && comment.integer(tag, 1, kGreatest, {"its tag"}) &&
                builder_.table.find(node) != kNoIndex) {
                builder_.mesh.points.push_back({NodeId{builder_.table.find(node)}, static_cast<std::int32_t>(tag)});
            }
        }
        return true;
    }

    bool readElements(const SourceText &source) {
        TextScanner scanner(source, '#');
        std::size_t count = 0;
        std::int64_t corners = 0, attributes = 0, number = 0;
        if (!scanner.count(count, 8, {"the number of triangles"}) ||
            !scanner.integer(corners, 3, 6, {"the nodes of a triangle"}) || !hasKind(scanner, corners) ||
            !scanner.integer(attributes, 0, 1000, {"the number of attributes"})) {
            return fail(scanner);
        }
        if (attributes > 1) {
            source.note("attributes", "attributes of triangles after the first one are ignored", 0, count);
        }
        const CellKind kind = corners == 3 ? CellKind::Triangle3 : CellKind::Triangle6;
        AttributeTags tags(builder_.mesh.regionNames, TagKind::Region);
        for (std::size_t k = 0; k < count; ++k) {
            double attribute = 0.0;
            std::int32_t region = attributes > 0 ? 0 : 1;
            if (!scanner.integer(number, 0, std::numeric_limits<std::int32_t>::max(), {"triangle", k + 1}) ||
                !builder_.readElement(scanner, kind, 1, {"triangle", static_cast<std::uint64_t>(number)},
                                      traitsOf(kind).opposite)) {
                return fail(scanner);
            }
            numbers_.push_back(number);
            for (std::int64_t a = 0; a < attributes; ++a) {
                if (!scanner.real(attribute, {"the attribute of triangle", static_cast<std::uint64_t>(number)})) {
                    return fail(scanner);
                }
                region = a == 0 ? tags.of(attribute) : region;
            }
            builder_.elements.regions.back() = region;
        }
        return noMore(scanner, count, "triangle");
    }

    bool readEdges(const SourceText &source) {
        TextScanner scanner(source, '#');
        std::size_t count = 0;
        std::int64_t markers = 0, number = 0;
        if (!scanner.count(count, 6, {"the number of edges"}) ||
            !scanner.integer(markers, 0, 1, {"the number of markers"})) {
            return fail(scanner);
        }
        for (std::size_t k = 0; k < count; ++k) {
            const Expect expect{"edge", k + 1};
            std::int64_t marker = 0;
            if (!scanner.integer(number, 0, std::numeric_limits<std::int32_t>::max(), expect) ||
                !builder_.readEdge(scanner, CellKind::Edge2, 1, expect) ||
                (markers == 1 && !scanner.integer(marker, -std::numeric_limits<std::int32_t>::max(),
                                                  std::numeric_limits<std::int32_t>::max(), expect))) {
                return fail(scanner);
            }
            if (marker == 0) {
                builder_.mesh.edges.pop_back(); // an inner edge
            } else {
                builder_.mesh.edges.back().tag = static_cast<std::int32_t>(marker);
            }
        }
        return noMore(scanner, count, "edge");
    }

    Result<Mesh> finish(const SourceText &source, const SourceText &nodes) {
        builder_.findMiddles(); // the edges have none
        source.numbered(PartNumbers(builder_.table.numbers()), builder_.elements.numbered(numbers_));
        Mesh mesh = builder_.finish();
        noteUnusedLabels(labels_, mesh, "node-markers", nodes);
        raiseTags(mesh, source);
        return mesh;
    }
    const Diagnostics &faults() const { return faults_; }

  private:
    static bool hasKind(TextScanner &scanner, std::int64_t nodes) {
        return nodes == 3 || nodes == 6 ||
               scanner.fail(scanner.offset(), "unknown-element",
                            "the triangles have " + std::to_string(nodes) + " nodes; expected 3 or 6");
    }

    /// Refuses a file that goes on after as many items as its first line announces.
    bool noMore(TextScanner &scanner, std::size_t count, const char *what) {
        if (!scanner.atEnd()) {
            const std::size_t place = scanner.offset();
            TextScanner line = scanner;
            std::size_t lines = count;
            while (scanner.nextLine(line)) {
                ++lines;
            }
            scanner.fail(place, "bad-count",
                         "the first line announces " + countText(count, what) + ", but " + std::to_string(lines) +
                             " lines follow",
                         "correct the number, or remove the lines after it");
            return fail(scanner);
        }
        return true;
    }

    bool fail(const TextScanner &scanner) {
        faults_ = scanner.faults();
        return false;
    }

    PlanarMeshBuilder builder_;
    std::vector<std::int64_t> numbers_; ///< of the triangles
    std::vector<std::int32_t> labels_;  ///< markers of the nodes; 0: none
    Diagnostics faults_;
};

} // namespace

namespace {

/// Returns the fault of a file that belongs to another mesh than the nodes do, such as after a copy that was cut short.
Diagnostics otherMesh(const SourceText &nodes, const SourceText &other) {
    const std::string_view ours = meshOf(nodes.text), theirs = meshOf(other.text);
    if (ours.empty() || theirs.empty() || ours == theirs) {
        return {};
    }
    Diagnostics fault = error("mixed-files",
                              "the file belongs to mesh " + std::string(theirs) + ", but " + nodes.name + " to mesh " +
                                  std::string(ours),
                              "write the mesh again, or put the files of one mesh together");
    fault.front().file = other.name;
    return fault;
}

} // namespace

Result<Mesh> readTriangleParts(const SourceText &nodes, const SourceText &elements, const SourceText *edges) {
    Diagnostics mixed = otherMesh(nodes, elements);
    if (mixed.empty() && edges != nullptr) {
        mixed = otherMesh(nodes, *edges);
    }
    if (!mixed.empty()) {
        return mixed;
    }
    TriangleMeshReader reader;
    if (!reader.readNodes(nodes) || !reader.readElements(elements) || (edges != nullptr && !reader.readEdges(*edges))) {
        return reader.faults();
    }
    return reader.finish(elements, nodes);
}

Result<Mesh> readTriangle(const SourceText &source) {
    const std::string extension = source.path.extension().string();
    const bool isElements = extension == ".ele" || extension == ".ELE";
    const auto other = readCompanion(source, isElements ? ".node" : ".ele");
    if (!other) {
        return other.faults();
    }
    const auto edges = readCompanion(source, ".edge");
    std::filesystem::path edgePath = source.path;
    std::error_code none;
    if (!edges && std::filesystem::exists(edgePath.replace_extension(".edge"), none)) {
        return edges.faults();
    }
    return readTriangleParts(isElements ? (*other)->source : source, isElements ? source : (*other)->source,
                             edges ? &(*edges)->source : nullptr);
}

} // namespace forefront
