#include "core/files/common/names.hpp"
#include "core/files/common/part_groups.hpp"
#include "core/files/common/planar_mesh.hpp"
#include "core/files/common/raise_tags.hpp"
#include "core/files/common/tag_allocator.hpp"
#include "core/files/unv/unv.hpp"
#include "core/files/unv/unv_cells.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront {

std::optional<CellKind> unvKind(std::int64_t type) {
    switch (type) {
    case 11: // rod; beams
    case 21:
    case 22:
        return CellKind::Edge2;
    case 23:
    case 24:
        return CellKind::Edge3;
    case 41: // plane stress, plane strain, plate, membrane, axisymmetric, thin shell
    case 51:
    case 61:
    case 74:
    case 81:
    case 91:
        return CellKind::Triangle3;
    case 42:
    case 52:
    case 62:
    case 72:
    case 82:
    case 92:
        return CellKind::Triangle6;
    case 44:
    case 54:
    case 64:
    case 71:
    case 84:
    case 94:
        return CellKind::Quadrilateral4;
    case 45:
    case 55:
    case 65:
    case 75:
    case 85:
    case 95:
        return CellKind::Quadrilateral8;
    default:
        return std::nullopt;
    }
}

namespace {

constexpr std::int64_t kMaxLabel = std::numeric_limits<std::int64_t>::max();
constexpr std::int32_t kUngrouped = std::numeric_limits<std::int32_t>::min(); ///< in place of a tag

std::string_view trimmed(std::string_view line) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    return begin == std::string_view::npos ? std::string_view()
                                           : line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
}

class UnvReader {
  public:
    explicit UnvReader(const SourceText &source) : scanner_(source) {}

    Result<Mesh> read() {
        findDatasets();
        if (scanner_.ok() && (!has({2411}) || !has({2412}))) {
            scanner_.fail(0, "bad-syntax",
                          std::string("the file has no dataset ") + (has({2411}) ? "2412 (elements)" : "2411 (nodes)"));
        }
        static_cast<void>(each({2411}, &UnvReader::nodes) && builder_.finishNodes(scanner_) &&
                          each({2412}, &UnvReader::cells) && findElements() &&
                          each({2435, 2452, 2467, 2477}, &UnvReader::groups));
        if (!scanner_.ok()) {
            return scanner_.faults();
        }
        tagTheRest();
        scanner_.source().numbered(PartNumbers(builder_.table.numbers()), builder_.elements.numbered(elementNumbers()));
        Mesh mesh = builder_.finish();
        mesh.boundaryNames = std::move(boundaryNames_);
        mesh.regionNames = std::move(regionNames_);
        raiseTags(mesh, scanner_.source());
        return mesh;
    }

  private:
    struct Dataset {
        std::int64_t number;
        std::size_t begin, end; ///< of its content
    };
    /// An element or edge as the file lists it.
    struct Cell {
        std::int32_t property;
        std::uint32_t index; ///< of the element or edge in the mesh
        bool plane;
    };
    using Content = bool (UnvReader::*)(TextScanner &content);

    std::string_view takeLine(std::size_t &at) const {
        const std::string_view text = scanner_.source().text;
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view line = text.substr(at, end - at);
        at = std::min(end + 1, text.size());
        return line;
    }

    /// Finds the datasets: each begins with a line -1 and one with its number, and ends with a line -1. Other lines
    /// between them are skipped.
    void findDatasets() {
        const std::string_view text = scanner_.source().text;
        for (std::size_t at = 0; at < text.size();) {
            if (!scanner_.proceed(at)) {
                return;
            }
            const std::size_t place = at;
            if (trimmed(takeLine(at)) != "-1") {
                continue;
            }
            TextScanner header = scanner_.part(at, std::min(text.find('\n', at), text.size()));
            std::int64_t number = 0;
            if (std::string_view(header.peek()).ends_with('b')) { // 58b, which holds measurements in binary
                number = 58;
            } else if (!header.integer(number, 1, 1'000'000, {"the number of a dataset"})) {
                scanner_.fail(header);
                return;
            }
            takeLine(at);
            Dataset dataset{number, at, at};
            bool closed = false;
            while (!closed && at < text.size()) {
                dataset.end = at;
                closed = trimmed(takeLine(at)) == "-1";
            }
            if (!closed) {
                scanner_.fail(place, "bad-syntax",
                              "dataset " + std::to_string(number) + " is not closed by a line with -1",
                              "the file may have been cut short");
                return;
            }
            add(dataset, place);
        }
    }

    void add(const Dataset &dataset, std::size_t place) {
        const SourceText &source = scanner_.source();
        switch (dataset.number) {
        case 2411:
        case 2412:
        case 2435:
        case 2452:
        case 2467:
        case 2477:
            datasets_.push_back(dataset);
            break;
        case 151: // the header and the units do not describe the mesh
        case 164:
            break;
        case 2420:
            source.warn("coordinate-systems",
                        "dataset 2420 (coordinate systems) is ignored: all coordinates are taken as global", place);
            break;
        default:
            source.note("dataset", "dataset " + std::to_string(dataset.number) + " is ignored", place);
        }
    }

    bool has(std::initializer_list<std::int64_t> numbers) const {
        return std::any_of(datasets_.begin(), datasets_.end(), [&](const Dataset &dataset) {
            return std::find(numbers.begin(), numbers.end(), dataset.number) != numbers.end();
        });
    }

    bool each(std::initializer_list<std::int64_t> numbers, Content content) {
        for (const Dataset &dataset : datasets_) {
            if (std::find(numbers.begin(), numbers.end(), dataset.number) != numbers.end()) {
                TextScanner part = scanner_.part(dataset.begin, dataset.end);
                if (!(this->*content)(part)) {
                    return scanner_.fail(part);
                }
            }
        }
        return scanner_.ok();
    }

    static bool integers(TextScanner &content, std::span<std::int64_t> values, Expect what) {
        return std::all_of(values.begin(), values.end(),
                           [&](std::int64_t &value) { return content.integer(value, -kMaxLabel, kMaxLabel, what); });
    }

    bool nodes(TextScanner &content) {
        while (!content.atEnd()) {
            std::int64_t values[4] = {}; // number, coordinate systems, colour
            if (!integers(content, values, {"the number, coordinate systems and colour of a node"}) ||
                !builder_.readNode(content, values[0], 3)) {
                return false;
            }
        }
        return true;
    }

    bool cells(TextScanner &content) {
        while (!content.atEnd()) {
            std::int64_t values[6] = {}; // number, type, property, material, colour, nodes
            const std::size_t place = content.offset();
            if (!integers(content, values, {"the number, type, property, material, colour and nodes of an element"})) {
                return false;
            }
            const auto number = static_cast<std::uint64_t>(values[0]);
            const std::optional<CellKind> kind = unvKind(values[1]);
            if (!kind || traitsOf(*kind).nodes != values[5]) {
                return content.fail(place, "unknown-element",
                                    "element " + std::to_string(values[0]) + " of type " + std::to_string(values[1]) +
                                        " with " + std::to_string(values[5]) +
                                        " nodes cannot be read; only rods, beams and plane elements of 3, 4, 6 or 8 "
                                        "nodes");
            }
            std::int64_t section[3] = {};
            if (isUnvBeam(values[1]) && !integers(content, section, {"the section of beam", number})) {
                return false;
            }
            if (!cell(content, *kind, {"element", number})) {
                return false;
            }
            const auto property = static_cast<std::int32_t>(
                std::clamp<std::int64_t>(values[2], kUngrouped + 1, std::numeric_limits<std::int32_t>::max()));
            const bool plane = traitsOf(*kind).dimension == 2;
            cells_.push_back(
                {property,
                 static_cast<std::uint32_t>((plane ? builder_.elements.size() : builder_.mesh.edges.size()) - 1),
                 plane});
            cellTable_.add(values[0]);
        }
        return true;
    }

    bool cell(TextScanner &content, CellKind kind, Expect expect) {
        CellOrder order = kSameOrder;
        for (std::size_t k = 0; k < traitsOf(kind).nodes; ++k) {
            order[k] = unvNode(traitsOf(kind), k);
        }
        return traitsOf(kind).dimension == 2 ? builder_.readElement(content, kind, kUngrouped, expect, order)
                                             : builder_.readEdge(content, kind, kUngrouped, expect, order);
    }

    bool findElements() {
        const std::uint32_t twin = cellTable_.finish();
        return twin == kNoIndex ||
               scanner_.fail(0, "duplicate-element",
                             "element " + std::to_string(cellTable_.number(twin)) + " occurs twice in dataset 2412");
    }

    /// Reads groups: eight numbers, a line with the name, and four numbers for each entity.
    bool groups(TextScanner &content) {
        origins_ = readGroupOrigins(scanner_.source().text, "#");
        while (!content.atEnd()) {
            const std::size_t place = content.offset();
            std::int64_t values[7] = {};
            std::size_t count = 0;
            if (!integers(content, values, {"the number and the sets of a group"}) ||
                !content.count(count, 8, {"the number of entities of a group"})) {
                return false;
            }
            content.skipLine();
            std::size_t at = content.offset();
            const std::string name = cleanName(takeLine(at));
            content.seek(at);
            if (!group(content, values[0], name, count, place)) {
                return false;
            }
        }
        return true;
    }

    bool group(TextScanner &content, std::int64_t number, const std::string &name, std::size_t count,
               std::size_t place) {
        std::vector<std::uint32_t> nodes;
        std::size_t others = 0, repeated = 0;
        const std::string what = "an entity of group " + std::to_string(number);
        const std::int32_t tag = tagOf(number, name);
        for (std::size_t k = 0; k < count; ++k) {
            std::int64_t entity[4] = {}; // type, number, leaf and component
            if (!integers(content, entity, {what.c_str()})) {
                return false;
            }
            const std::uint32_t found = entity[0] == 8   ? cellTable_.find(entity[1])
                                        : entity[0] == 7 ? builder_.table.find(entity[1])
                                                         : kNoIndex;
            if (found == kNoIndex) {
                ++others;
            } else if (entity[0] == 7) {
                nodes.push_back(found);
            } else {
                repeated += put(cells_[found], tag, name) ? 0 : 1;
            }
        }
        const SourceText &source = scanner_.source();
        if (others > 0) {
            source.note("group",
                        "groups have entities other than the nodes and elements of the mesh, which are ignored", place,
                        others);
        }
        if (repeated > 0) {
            source.note("group",
                        "elements of group " + inQuotes(name) + " keep the group before, as they have only one", place,
                        repeated);
        }
        points(nodes, number, tag, name, place);
        return true;
    }

    /// Returns the tag of a group: the one that the file tells, else its number, else a free one.
    std::int32_t tagOf(std::int64_t number, const std::string &name) {
        const auto origin = number >= 1 && number <= std::numeric_limits<std::int32_t>::max()
                                ? origins_.find(static_cast<std::int32_t>(number))
                                : origins_.end();
        if (origin != origins_.end()) {
            return origin->second.tag;
        }
        if (number >= 1 && number <= std::numeric_limits<std::int32_t>::max()) {
            return static_cast<std::int32_t>(number);
        }
        return freeTags_.of(name);
    }

    /// Gives an element or edge the tag of a group, unless it has one. Returns false if it has.
    bool put(const Cell &cell, std::int32_t tag, const std::string &name) {
        std::int32_t &target = cell.plane ? builder_.elements.regions[cell.index] : builder_.mesh.edges[cell.index].tag;
        if (target != kUngrouped) {
            return false;
        }
        target = tag;
        addGroupName(cell.plane ? 2 : 1, tag, name);
        return true;
    }

    void addGroupName(int dimension, std::int32_t tag, const std::string &name) {
        const auto origin = std::find_if(origins_.begin(), origins_.end(), [&](const auto &each) {
            return each.second.dimension == dimension && each.second.tag == tag;
        });
        addName(dimension == 2 ? regionNames_ : boundaryNames_, tag,
                origin != origins_.end() ? origin->second.name : name, dimension == 2);
    }

    /// Makes points of a group of nodes if it is one of ours or a single node. Groups of more nodes are usually those
    /// along a boundary, which the edges there tell better.
    void points(const std::vector<std::uint32_t> &nodes, std::int64_t number, std::int32_t tag, const std::string &name,
                std::size_t place) {
        const bool ours = number >= 1 && number <= std::numeric_limits<std::int32_t>::max() &&
                          origins_.contains(static_cast<std::int32_t>(number)) &&
                          origins_.at(static_cast<std::int32_t>(number)).dimension == 0;
        if (!ours && nodes.size() > 1) {
            scanner_.source().note("group", "group " + inQuotes(name) + " of nodes is ignored", place);
            return;
        }
        for (const std::uint32_t node : nodes) {
            builder_.mesh.points.push_back({NodeId{node}, tag});
            addGroupName(0, tag, name);
        }
    }

    /// Elements and edges of no group get the number of their property, or a free tag if there are groups: numbers of
    /// properties and groups have nothing to do with each other.
    void tagTheRest() {
        TagAllocator regions, boundaries;
        bool grouped = false;
        for (const std::int32_t tag : builder_.elements.regions) {
            regions.reserve(tag);
            grouped = grouped || tag != kUngrouped;
        }
        for (const TaggedEdge &edge : builder_.mesh.edges) {
            boundaries.reserve(edge.tag);
            grouped = grouped || edge.tag != kUngrouped;
        }
        for (const Cell &cell : cells_) {
            std::int32_t &tag =
                cell.plane ? builder_.elements.regions[cell.index] : builder_.mesh.edges[cell.index].tag;
            if (tag == kUngrouped) {
                tag = grouped ? (cell.plane ? regions : boundaries).of("") : cell.property;
            }
        }
    }

    std::vector<std::int64_t> elementNumbers() const {
        std::vector<std::int64_t> numbers;
        for (std::size_t k = 0; k < cells_.size(); ++k) {
            if (cells_[k].plane) {
                numbers.push_back(cellTable_.number(k));
            }
        }
        return numbers;
    }

    TextScanner scanner_;
    PlanarMeshBuilder builder_;
    std::vector<Dataset> datasets_;
    std::vector<Cell> cells_; ///< in the order of the file
    NodeTable cellTable_;     ///< their numbers
    std::map<std::int32_t, PartGroup> origins_;
    TagAllocator freeTags_;
    std::map<std::int32_t, std::string> boundaryNames_, regionNames_;
};

} // namespace

bool looksLikeUnv(std::string_view head) {
    while (!head.empty()) {
        const std::size_t end = std::min(head.find('\n'), head.size());
        const std::string_view line = trimmed(head.substr(0, end));
        head.remove_prefix(std::min(end + 1, head.size()));
        if (line == "-1") {
            const std::string_view number = trimmed(head.substr(0, head.find('\n')));
            return !number.empty() && number.size() <= 6 &&
                   number.find_first_not_of("0123456789b") == std::string_view::npos;
        }
        if (!line.empty() && !line.starts_with('#')) {
            return false;
        }
    }
    return false;
}

Result<Mesh> readUnv(const SourceText &source) {
    return UnvReader(source).read();
}

} // namespace forefront
