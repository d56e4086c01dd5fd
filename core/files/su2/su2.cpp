#include "core/files/su2/su2.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/files/common/names.hpp"
#include "core/files/common/planar_mesh.hpp"
#include "core/files/common/tag_allocator.hpp"
#include "core/files/common/tagged_cells.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr int kLine = 3, kTriangle = 5; // as in VTK

FileNames markersOf(const TagList &tags) {
    UniqueNames unique;
    return identifiersOf({.edges = tags.edges, .points = {}, .regions = {}}, unique);
}

/// Writes the regions of runs of elements, unless all are 1.
void writeRegionRuns(const MeshView &mesh, TextWriter &out) {
    std::vector<std::pair<std::size_t, std::int32_t>> runs; // number of elements, region
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size(); ++k) {
            if (runs.empty() || runs.back().second != block.region(k)) {
                runs.emplace_back(0, block.region(k));
            }
            ++runs.back().first;
        }
    }
    if (std::all_of(runs.begin(), runs.end(), [](const auto &run) { return run.second == 1; })) {
        return;
    }
    for (const auto &[count, region] : runs) {
        out << "% elements " << count << ' ' << region << '\n';
    }
}

} // namespace

/// Writes a two-dimensional SU2 mesh. Each boundary tag is a marker. Comments hold what SU2 cannot express: "% tag TAG"
/// before a marker, "% elements COUNT TAG" for each run of elements of a region, "% point NODE TAG". The file is ASCII,
/// since SU2 stops at other characters, even in comments.
void writeSu2(const MeshView &mesh, TextWriter &out) {
    writeNameComments(mesh, "%", out);
    for (const TaggedNode &point : mesh.points) {
        out << "% point " << index(point.node) << ' ' << point.tag << '\n';
    }
    writeRegionRuns(mesh, out);
    out << "NDIME= 2\nNELEM= " << mesh.elementCount() << '\n';
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size() && out.ok(); ++k) {
            out << block.traits().vtk;
            for (const NodeId node : block.nodesOf(k)) {
                out << ' ' << index(node);
            }
            out << ' ' << block.first + k << '\n';
        }
    }
    out << "NPOIN= " << mesh.nodes.size() << '\n';
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << mesh.nodes[n].x << ' ' << mesh.nodes[n].y << ' ' << n << '\n';
    }
    const PartsByTag markers = edgesByTag(mesh);
    const FileNames names = markersOf(tagsOf(mesh));
    out << "NMARK= " << markers.size() << '\n';
    for (const auto &[tag, edges] : markers) {
        out << "% tag " << tag << "\nMARKER_TAG= " << names.edges.at(tag) << "\nMARKER_ELEMS= " << edges.size() << '\n';
        for (const std::uint32_t k : edges) {
            out << kLine << ' ' << index(mesh.edges[k].a) << ' ' << index(mesh.edges[k].b) << '\n';
        }
    }
}

Diagnostics noteSu2Changes(const MeshView &mesh) {
    const TagList tags = tagsOf(mesh);
    return noteChangedNames(tags, markersOf(tags));
}

namespace {

/// Reads lines "KEY= value"; elements may precede the nodes, so their nodes are resolved at the end.
class Su2Reader {
  public:
    explicit Su2Reader(const SourceText &source) : scanner_(source, '%', '=') {}

    Result<Mesh> read() {
        comments();
        TextScanner line = scanner_;
        while (scanner_.ok() && scanner_.nextLine(line)) {
            if (!keyword(line)) {
                scanner_.fail(line);
            }
        }
        if (scanner_.ok() && markersDeclared_ >= 0 && markersDeclared_ != markers_) {
            scanner_.fail(markersPlace_, "bad-count",
                          "NMARK is " + std::to_string(markersDeclared_) + ", but the file holds " +
                              countText(static_cast<std::size_t>(markers_), "marker"),
                          "the file may have been cut short");
        }
        resolve();
        if (!scanner_.ok()) {
            return scanner_.faults();
        }
        scanner_.source().numbered(PartNumbers(), builder_.elements.numberedFrom(0));
        return builder_.finish();
    }

  private:
    /// Positions of the connections in the file.
    struct Connection {
        std::size_t offset;
        std::int32_t tag; ///< of the edge; 0: an element
    };

    bool keyword(TextScanner &line) {
        const std::size_t place = line.offset();
        const std::string_view word = line.word();
        std::int64_t number = 0;
        std::size_t count = 0;
        if (ignoring_ && word.find_first_of("+-.0123456789") == 0) {
            return true; // data of a keyword that is ignored
        }
        ignoring_ = isIgnored(word);
        if (ignoring_) {
            scanner_.source().note("keyword",
                                   word.starts_with("FFD_") ? std::string("boxes of deformation (FFD) are ignored")
                                                            : "keyword " + std::string(word) + " is ignored",
                                   place);
            return true;
        }
        if (word == "NDIME") {
            line.peek();
            const std::size_t at = line.offset();
            return line.integer(number, 1, 3, {"the dimension"}) &&
                   (number == 2 ||
                    line.fail(at, "not-planar",
                              "the mesh has " + std::to_string(number) + " dimension" + (number == 1 ? "" : "s"),
                              "only planar meshes can be read"));
        }
        if (word == "NELEM") {
            return itemCount(line, count, 7, "the number of elements") && connections(count, 0);
        }
        if (word == "NPOIN") {
            return itemCount(line, count, 4, "the number of points") && points(count);
        }
        if (word == "NMARK") {
            markersPlace_ = place;
            return line.integer(markersDeclared_, 0, std::numeric_limits<std::int32_t>::max(),
                                {"the number of markers"});
        }
        if (word == "MARKER_TAG") {
            ++markers_;
            marker(place, line.rest());
            return true;
        }
        if (word == "MARKER_ELEMS") {
            return itemCount(line, count, 5, "the number of marker elements") && connections(count, markerTag_);
        }
        if (word == "NZONE") {
            return line.integer(number, 1, std::numeric_limits<std::int32_t>::max(), {"the number of zones"}) &&
                   (number == 1 || line.fail(place, "several-zones", "files of several zones cannot be read",
                                             "write each zone to a file of its own"));
        }
        return line.fail(place, "bad-syntax", "expected a keyword such as NELEM=, found " + inQuotes(word));
    }

    /// Returns true for keywords about how a solver uses the mesh. Lines of numbers may follow them.
    static bool isIgnored(std::string_view word) {
        constexpr std::array kIgnored = {"SEND_RECV", "IZONE", "NCHUNK", "NPERIODIC", "AOA_OFFSET", "AOS_OFFSET"};
        return word.starts_with("FFD_") || word.starts_with("PERIODIC_") ||
               std::find(kIgnored.begin(), kIgnored.end(), word) != kIgnored.end();
    }

    bool itemCount(TextScanner &line, std::size_t &count, std::size_t bytes, const char *what) {
        line.peek();
        TextScanner whole = scanner_.part(line.offset(), scanner_.source().text.size());
        return whole.count(count, bytes, {what}) || line.fail(whole);
    }

    bool connections(std::size_t count, std::int32_t tag) {
        for (std::size_t k = 0; k < count; ++k) {
            TextScanner line = scanner_;
            if (!scanner_.nextLine(line)) {
                return scanner_.fail(scanner_.offset(), "bad-syntax",
                                     "expected more elements, found the end of the file");
            }
            connections_.push_back({line.offset(), tag});
        }
        return true;
    }

    bool points(std::size_t count) {
        builder_.reserveNodes(count);
        for (std::size_t k = 0; k < count; ++k) {
            TextScanner line = scanner_;
            if (!scanner_.nextLine(line)) {
                return scanner_.fail(scanner_.offset(), "bad-syntax",
                                     "expected more points, found the end of the file");
            }
            if (!builder_.readNode(line, static_cast<std::int64_t>(builder_.mesh.nodes.size()), 2)) {
                return scanner_.fail(line);
            }
        }
        return true;
    }

    void marker(std::size_t place, std::string_view name) {
        // Our tag number is in a comment on the previous line.
        const std::string_view before = scanner_.source().text.substr(0, place);
        const std::size_t comment = before.rfind("% tag ");
        std::int64_t number = 0;
        if (comment != std::string_view::npos && before.find('\n', comment) == place - 1) {
            TextScanner line = scanner_.part(comment + 6, place);
            if (line.integer(number, 1, std::numeric_limits<std::int32_t>::max(), {"the tag of a marker"})) {
                markerTag_ = static_cast<std::int32_t>(number);
                return;
            }
        }
        markerTag_ = tags_.of(cleanName(name));
    }

    void resolve() {
        if (!builder_.finishNodes(scanner_)) {
            return;
        }
        if (builder_.mesh.nodes.empty()) {
            scanner_.fail(scanner_.offset(), "bad-syntax", "the file has no points (NPOIN=)");
            return;
        }
        scanner_.seek(0); // the elements are read again, which can be cancelled, too
        for (std::size_t k = 0; k < connections_.size(); ++k) {
            if (!scanner_.proceed(connections_[k].offset)) {
                return;
            }
            TextScanner item = scanner_.part(connections_[k].offset, scanner_.source().text.size());
            std::int64_t type = 0;
            const Expect expect{connections_[k].tag == 0 ? "element" : "marker element", k};
            if (!item.integer(type, 1, 100, expect)) {
                scanner_.fail(item);
                return;
            }
            const std::optional<CellKind> kind = cellNumbered(&CellTraits::vtk, type); // SU2 numbers cells as VTK does
            const bool isElement = kind && traitsOf(*kind).dimension == 2;
            if (!kind || traitsOf(*kind).order != 1 || isElement != (connections_[k].tag == 0)) {
                scanner_.fail(connections_[k].offset, "unknown-element",
                              "an element of type " + std::to_string(type) +
                                  " cannot be read; only triangles (5), quadrilaterals (9) and lines (3) on markers");
                return;
            }
            const bool done = isElement                  ? builder_.readElement(item, *kind, 1, expect)
                              : *kind == CellKind::Point ? builder_.readPoint(item, connections_[k].tag, expect)
                                                         : builder_.readEdge(item, *kind, connections_[k].tag, expect);
            if (!done) {
                scanner_.fail(item);
                return;
            }
        }
        applyComments();
    }

    void comments() {
        names_ = readNameComments(scanner_.source().text, "%");
        for (const auto &[tag, name] : names_.boundary) {
            tags_.reserve(tag);
        }
    }

    /// Applies the comments "% elements COUNT TAG" and "% point NODE TAG". Skips values that do not fit the mesh, since
    /// these are only comments.
    void applyComments() {
        const std::string_view text = scanner_.source().text;
        std::size_t element = 0;
        forEachComment(text, "% elements ", [&](std::int64_t count, std::int32_t tag) {
            for (; count > 0 && element < builder_.elements.size(); --count) {
                builder_.elements.regions[element++] = tag;
            }
        });
        forEachComment(text, "% point ", [&](std::int64_t node, std::int32_t tag) {
            if (node >= 0 && static_cast<std::size_t>(node) < builder_.mesh.nodes.size()) {
                builder_.mesh.points.push_back({NodeId{static_cast<std::uint32_t>(node)}, tag});
            }
        });
        builder_.mesh.boundaryNames = tags_.names();
        builder_.mesh.boundaryNames.insert(names_.boundary.begin(), names_.boundary.end());
        builder_.mesh.regionNames = std::move(names_.region);
    }

    template <class Take>
    void forEachComment(std::string_view text, std::string_view start, Take take) {
        for (std::size_t at = text.find(start); at != std::string_view::npos; at = text.find(start, at + 1)) {
            if (at > 0 && text[at - 1] != '\n') {
                continue;
            }
            TextScanner line = scanner_.part(at + start.size(), std::min(text.find('\n', at), text.size()));
            std::int64_t number = 0, tag = 0;
            constexpr std::int64_t kGreatest = std::numeric_limits<std::int32_t>::max();
            if (line.integer(number, 0, kGreatest, {"a comment"}) && line.integer(tag, 1, kGreatest, {"a comment"})) {
                take(number, static_cast<std::int32_t>(tag));
            }
        }
    }

    TextScanner scanner_;
    PlanarMeshBuilder builder_;
    std::vector<Connection> connections_;
    std::int32_t markerTag_ = 1;
    std::int64_t markersDeclared_ = -1, markers_ = 0;
    std::size_t markersPlace_ = 0;
    bool ignoring_ = false; ///< after a keyword that is ignored: until the next one
    TagAllocator tags_;
    TagNames names_;
};

} // namespace

bool looksLikeSu2(std::string_view head) {
    return head.find("NDIME") != std::string_view::npos || head.find("NELEM") != std::string_view::npos;
}

Result<Mesh> readSu2(const SourceText &source) {
    return Su2Reader(source).read();
}

} // namespace forefront
