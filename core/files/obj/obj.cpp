#include "core/files/obj/obj.hpp"

#include "core/files/common/names.hpp"
#include "core/files/common/planar_mesh.hpp"
#include "core/files/common/tag_allocator.hpp"
#include "core/files/common/tagged_cells.hpp"

#include <limits>
#include <span>

namespace forefront {

namespace {

FileNames groupsOf(const TagList &tags) {
    UniqueNames unique;
    return identifiersOf(tags, unique);
}

} // namespace

/// Writes Wavefront OBJ: a group of faces per region, a group of lines per boundary tag, a group of points per tag.
/// Comments hold the original names and the tags: "# tag TAG" belongs to the group before it.
void writeObj(const MeshView &mesh, TextWriter &out) {
    writeNameComments(mesh, "#", out);
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << "v " << mesh.nodes[n].x << ' ' << mesh.nodes[n].y << " 0\n";
    }
    const FileNames names = groupsOf(tagsOf(mesh));
    const auto group = [&](const std::string &name, std::int32_t tag) {
        out << "g " << name << "\n# tag " << tag << '\n';
    };
    for (const auto &[tag, elements] : elementsByRegion(mesh)) {
        group(names.regions.at(tag), tag);
        for (std::size_t k = 0; k < elements.size() && out.ok(); ++k) {
            out << 'f';
            for (const NodeId node : mesh.cornersOf(elements[k])) {
                out << ' ' << index(node) + 1;
            }
            out << '\n';
        }
    }
    for (const auto &[tag, edges] : edgesByTag(mesh)) {
        group(names.edges.at(tag), tag);
        for (const std::uint32_t k : edges) {
            out << "l " << index(mesh.edges[k].a) + 1 << ' ' << index(mesh.edges[k].b) + 1 << '\n';
        }
    }
    for (const auto &[tag, items] : pointsByTag(mesh)) {
        group(names.points.at(tag), tag);
        for (const std::uint32_t k : items) {
            out << "p " << index(mesh.points[k].node) + 1 << '\n';
        }
    }
}

Diagnostics noteObjChanges(const MeshView &mesh) {
    const TagList tags = tagsOf(mesh);
    return noteChangedNames(tags, groupsOf(tags));
}

namespace {

class ObjReader {
  public:
    explicit ObjReader(const SourceText &source) : scanner_(source) {}

    Result<Mesh> read() {
        TagNames names = readNameComments(scanner_.source().text, "#");
        for (const auto &[tag, name] : names.boundary) {
            boundaries_.reserve(tag);
        }
        for (const auto &[tag, name] : names.region) {
            regions_.reserve(tag);
        }
        TextScanner line = scanner_;
        while (scanner_.ok() && scanner_.nextLine(line)) {
            if (!statement(line)) {
                scanner_.fail(line);
            }
        }
        if (builder_.mesh.nodes.empty()) {
            scanner_.fail(scanner_.offset(), "bad-syntax", "the file has no vertices");
        }
        if (!builder_.finishNodes(scanner_) || !faces()) {
            return scanner_.faults();
        }
        scanner_.source().numbered(PartNumbers(1), builder_.elements.numberedFrom(1));
        Mesh mesh = builder_.finish();
        mesh.boundaryNames = std::move(names.boundary);
        mesh.regionNames = std::move(names.region);
        mesh.boundaryNames.insert(boundaries_.names().begin(), boundaries_.names().end());
        mesh.regionNames.insert(regions_.names().begin(), regions_.names().end());
        return mesh;
    }

  private:
    enum class Kind : std::uint8_t { Face, Line, Point };
    struct Item {
        std::size_t offset;
        Kind kind;
        std::uint32_t group;
        std::uint32_t nodes; ///< nodes defined before it; negative numbers count back from there
    };
    struct Group {
        std::string name;
        std::int64_t tag = 0; ///< 0: by the name
    };

    bool statement(TextScanner &line) {
        const std::size_t place = line.offset();
        const std::string_view word = line.word();
        if (word == "v") {
            if (!builder_.readNode(line, static_cast<std::int64_t>(builder_.mesh.nodes.size()) + 1, 3)) {
                return false;
            }
            if (!line.atEnd()) {
                scanner_.source().note("vertex-values", "values of vertices after x, y and z are ignored", place);
            }
            return true;
        }
        if (word == "f" || word == "l" || word == "p") {
            const Kind kind = word == "f" ? Kind::Face : word == "l" ? Kind::Line : Kind::Point;
            items_.push_back({line.offset(), kind, static_cast<std::uint32_t>(groups_.size() - 1),
                              static_cast<std::uint32_t>(builder_.mesh.nodes.size())});
        } else if (word == "g" || word == "o") {
            groups_.push_back({cleanName(line.rest()), 0});
        } else if (word == "#" && line.peek() == "tag") {
            line.word();
            std::int64_t tag = 0; // other words may follow in comments of other programs
            if (line.integer(tag, 1, std::numeric_limits<std::int32_t>::max(), {"the tag of a group"}) &&
                line.atEnd()) {
                groups_.back().tag = tag;
            }
        } else if (!word.starts_with('#')) {
            scanner_.source().note("statement", "statement " + inQuotes(word) + " is ignored", place);
        }
        return true;
    }

    std::int32_t tagOf(const Item &item) {
        Group &group = groups_[item.group];
        if (group.tag == 0) {
            return (item.kind == Kind::Face ? regions_ : boundaries_).of(group.name);
        }
        return static_cast<std::int32_t>(group.tag);
    }

    /// Faces and lines refer to nodes as 7, 7/1, 7//2 or -1 (the last so far).
    bool node(TextScanner &line, const Item &item, NodeId &id, Expect expect) {
        line.peek();
        const std::size_t offset = line.offset();
        const std::string_view word = line.word();
        TextScanner digits = scanner_.part(offset, offset + std::min(word.find('/'), word.size()));
        std::int64_t number = 0;
        const auto count = static_cast<std::int64_t>(builder_.mesh.nodes.size());
        if (!digits.integer(number, -std::int64_t{item.nodes}, count, expect)) {
            return scanner_.fail(digits);
        }
        number = number < 0 ? number + item.nodes + 1 : number;
        if (number == 0) {
            return scanner_.fail(offset, "bad-index", "node numbers start at 1");
        }
        id = NodeId{static_cast<std::uint32_t>(number - 1)};
        return true;
    }

    bool faces() {
        const std::string_view text = scanner_.source().text;
        scanner_.seek(0); // the items are read again, which can be cancelled, too
        for (std::size_t k = 0; k < items_.size(); ++k) {
            const Item &item = items_[k];
            if (!scanner_.proceed(item.offset)) {
                return false;
            }
            TextScanner line = scanner_.part(item.offset, std::min(text.find('\n', item.offset), text.size()));
            const Expect expect{item.kind == Kind::Face ? "face" : "line or point", k + 1};
            NodeId nodes[4] = {};
            std::size_t expected = item.kind == Kind::Face ? 3 : item.kind == Kind::Line ? 2 : 1;
            for (std::size_t n = 0; n < expected; ++n) {
                if (!node(line, item, nodes[n], expect)) {
                    return false;
                }
                expected = item.kind == Kind::Face && n == 2 && !line.atEnd() ? 4 : expected;
            }
            if (!requireDistinct(scanner_, item.offset, std::span(nodes).first(expected), expect)) {
                return false;
            }
            const std::int32_t tag = tagOf(item);
            if (item.kind == Kind::Face) {
                if (!line.atEnd()) {
                    return scanner_.fail(line.offset(), "unknown-element", "only faces with 3 or 4 nodes can be read");
                }
                builder_.elements.add(expected == 3 ? CellKind::Triangle3 : CellKind::Quadrilateral4,
                                      std::span(nodes).first(expected), tag);
            } else if (item.kind == Kind::Point) {
                builder_.mesh.points.push_back({nodes[0], tag});
                while (!line.atEnd()) {
                    if (!node(line, item, nodes[0], expect)) {
                        return false;
                    }
                    builder_.mesh.points.push_back({nodes[0], tag});
                }
            } else if (!polyline(line, item, nodes, tag, expect)) {
                return false;
            }
        }
        return true;
    }

    bool polyline(TextScanner &line, const Item &item, NodeId (&nodes)[4], std::int32_t tag, Expect expect) {
        builder_.mesh.edges.push_back({nodes[0], nodes[1], tag});
        while (!line.atEnd()) {
            nodes[0] = nodes[1];
            if (!node(line, item, nodes[1], expect) ||
                !requireDistinct(scanner_, item.offset, std::span(nodes).first(2), expect)) {
                return false;
            }
            builder_.mesh.edges.push_back({nodes[0], nodes[1], tag});
        }
        return true;
    }

    TextScanner scanner_;
    PlanarMeshBuilder builder_;
    std::vector<Item> items_;
    std::vector<Group> groups_ = {Group{}};
    TagAllocator boundaries_, regions_;
};

} // namespace

Result<Mesh> readObj(const SourceText &source) {
    return ObjReader(source).read();
}

} // namespace forefront
