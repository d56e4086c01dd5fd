#include "core/engine/base/letter_case.hpp"
#include "core/files/abaqus/abaqus.hpp"
#include "core/files/common/names.hpp"
#include "core/files/common/planar_mesh.hpp"
#include "core/files/common/tag_allocator.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace forefront {

namespace {

constexpr std::int64_t kGreatest = std::numeric_limits<std::int32_t>::max();
constexpr std::int32_t kNoSet = 0; ///< in place of the tag of elements outside every set

/// Lines of 3 nodes have their middle node between the ends.
constexpr CellOrder kAbaqusEdge3 = {0, 2, 1};

/// Returns the kind of cells of an element type such as "CPS8R": a family of plane elements, the number of nodes, and
/// letters about its formulation.
std::optional<CellKind> abaqusKind(const std::string &type) {
    constexpr std::array kLines = {"T3D2", "T2D2", "B21", "B31", "R2D2"};
    constexpr std::array kLines3 = {"T3D3", "T2D3", "B22", "B32"};
    constexpr std::array<std::string_view, 11> kFamilies = {"CPS",   "CPE", "CAX",  "S",    "STRI", "M3D",
                                                            "SFM3D", "R3D", "DC2D", "DCAX", "AC2D"};
    if (std::find(kLines.begin(), kLines.end(), type) != kLines.end()) {
        return CellKind::Edge2;
    }
    if (std::find(kLines3.begin(), kLines3.end(), type) != kLines3.end()) {
        return CellKind::Edge3;
    }
    if (type == "STRI65") {
        return CellKind::Triangle6;
    }
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    for (const std::string_view family : kFamilies) {
        const std::size_t at = family.size();
        if (type.starts_with(family) && type.size() > at && isDigit(type[at]) &&
            (type.size() == at + 1 || !isDigit(type[at + 1]))) {
            return elementOfNodes(type[at] - '0');
        }
    }
    return std::nullopt;
}

/// Reads Abaqus input: nodes, plane elements, element sets as regions, element surfaces as tagged edges. Other
/// keywords are skipped.
class AbaqusReader {
  public:
    explicit AbaqusReader(const SourceText &source) : scanner_(source, '\0', ',') {}

    Result<Mesh> read() {
        const std::string_view text = scanner_.source().text;
        TagNames names = readNameComments(text, "**");
        for (const auto &[tag, name] : names.boundary) {
            boundaries_.reserve(tag);
        }
        for (const auto &[tag, name] : names.region) {
            regions_.reserve(tag);
        }
        const std::size_t begin = scanner_.offset();
        sections(); // first pass: nodes only, because some programs write them after the elements, or in several places
        if (scanner_.ok() && !hasElements_) {
            scanner_.fail(scanner_.offset(), "bad-syntax", "the file has no *NODE or *ELEMENT section");
        }
        if (scanner_.ok() && builder_.finishNodes(scanner_)) {
            scanner_.seek(begin);
            nodesFinished_ = true;
            tagComment_ = pointComment_ = 0;
            sections();
        }
        if (!scanner_.ok()) {
            return scanner_.faults();
        }
        tagTheRest();
        noteNodeSets();
        sortElements();
        scanner_.source().numbered(PartNumbers(builder_.table.numbers()), builder_.elements.numbered(numbers_));
        Mesh mesh = builder_.finish();
        mesh.boundaryNames = std::move(names.boundary);
        mesh.regionNames = std::move(names.region);
        mesh.boundaryNames.insert(boundaries_.names().begin(), boundaries_.names().end());
        mesh.regionNames.insert(regions_.names().begin(), regions_.names().end());
        return mesh;
    }

  private:
    struct Keyword {
        std::size_t offset = 0;
        std::string name;
        std::map<std::string, std::string> parameters;
    };

    std::string_view line() {
        const std::string_view text = scanner_.source().text;
        const std::size_t begin = scanner_.offset();
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lineOffset_ = begin;
        scanner_.seek(end);
        return text.substr(begin, end - begin);
    }

    void sections() {
        while (scanner_.ok() && !scanner_.atEnd()) {
            keyword(line());
        }
    }

    void keyword(std::string_view text) {
        if (text.starts_with("**")) {
            comment(text);
            return;
        }
        if (!text.starts_with('*')) {
            scanner_.fail(lineOffset_, "bad-syntax", "expected a keyword that begins with *, found " + inQuotes(text));
            return;
        }
        Keyword keyword;
        keyword.offset = lineOffset_;
        while (true) {
            const std::size_t comma = std::min(text.find(','), text.size());
            const std::string_view part = text.substr(0, comma);
            const std::size_t equals = std::min(part.find('='), part.size());
            const std::string key = upperCase(cleanName(part.substr(0, equals)));
            if (keyword.name.empty()) {
                keyword.name = key;
            } else {
                keyword.parameters[key] = cleanName(part.substr(std::min(equals + 1, part.size())));
            }
            if (comma == text.size()) {
                break;
            }
            text.remove_prefix(comma + 1);
        }
        data(keyword);
        tagComment_ = pointComment_ = 0;
    }

    void comment(std::string_view text) {
        for (const auto &[start, target] :
             {std::pair{"** tag ", &tagComment_}, std::pair{"** point ", &pointComment_}}) {
            if (text.starts_with(start)) {
                TextScanner number =
                    scanner_.part(lineOffset_ + std::string_view(start).size(), lineOffset_ + text.size());
                std::int64_t tag = 0;
                *target = number.integer(tag, 1, kGreatest, {"a tag"}) ? static_cast<std::int32_t>(tag) : 0;
            }
        }
    }

    /// Returns true while data lines follow.
    bool more() { return scanner_.ok() && !scanner_.atEnd() && scanner_.source().text[scanner_.offset()] != '*'; }

    void data(const Keyword &keyword) {
        hasElements_ = hasElements_ || keyword.name == "*ELEMENT";
        parts_ += keyword.name == "*PART" && !nodesFinished_ ? 1 : 0;
        const bool ofThisPass = nodesFinished_ != (keyword.name == "*NODE");
        if (parts_ > 1) {
            scanner_.fail(keyword.offset, "several-parts", "files of several parts cannot be read",
                          "write one part, or a flat input file without parts and assemblies");
        } else if (!ofThisPass) {
            skipData();
        } else if (keyword.name == "*INCLUDE" || keyword.parameters.contains("INPUT")) {
            scanner_.fail(keyword.offset, "unknown-section", "included files are not read",
                          "put their lines in the place of the keyword");
        } else if (!nodesFinished_) {
            nodes(keyword);
        } else if (keyword.name == "*ELEMENT") {
            elements(keyword);
        } else if (keyword.name == "*ELSET") {
            elementSet(keyword);
        } else if (keyword.name == "*NSET" && pointComment_ > 0) {
            points();
        } else if (keyword.name == "*SURFACE") {
            surface(keyword);
        } else if (keyword.name == "*SYSTEM") {
            scanner_.fail(keyword.offset, "coordinate-system",
                          "nodes in a coordinate system of their own cannot be read",
                          "write the nodes in global coordinates");
        } else {
            if (keyword.name == "*NSET") {
                nodeSets_.emplace_back(upperCase(parameter(keyword, "NSET")), keyword.offset);
            } else if (keyword.name != "*HEADING") {
                scanner_.source().note("keyword", "keyword " + inQuotes(keyword.name) + " is ignored", keyword.offset);
            }
            skipData();
        }
    }

    void skipData() {
        while (more()) {
            line();
        }
    }

    void nodes(const Keyword &keyword) {
        const std::string system = upperCase(parameter(keyword, "SYSTEM"));
        if (!system.empty() && system != "R") {
            scanner_.fail(keyword.offset, "coordinate-system",
                          "nodes in the coordinate system " + inQuotes(system) +
                              " cannot be read; expected rectangular coordinates",
                          "write the nodes in global coordinates");
            return;
        }
        if (const std::string set = upperCase(parameter(keyword, "NSET")); !set.empty() && set != "NALL") {
            nodeSets_.emplace_back(set, keyword.offset);
        }
        while (more()) {
            TextScanner fields = scanner_;
            std::int64_t number = 0;
            scanner_.nextLine(fields);
            if (!fields.integer(number, 1, kGreatest, {"the number of a node"}) || !readPlace(fields, number)) {
                scanner_.fail(fields);
            }
        }
    }

    bool readPlace(TextScanner &fields, std::int64_t number) {
        // A third coordinate may be missing.
        TextScanner probe = fields;
        probe.word();
        probe.word();
        return builder_.readNode(fields, number, probe.atEnd() ? 2 : 3);
    }

    static std::string parameter(const Keyword &keyword, const char *name) {
        const auto found = keyword.parameters.find(name);
        return found != keyword.parameters.end() ? found->second : std::string();
    }

    void elements(const Keyword &keyword) {
        const std::string type = upperCase(parameter(keyword, "TYPE"));
        const std::string set = parameter(keyword, "ELSET");
        const std::optional<CellKind> kind = abaqusKind(type);
        if (!kind) {
            scanner_.fail(keyword.offset, "unknown-element",
                          "elements of type " + inQuotes(type) +
                              " cannot be read; expected plane elements of 3, 4, 6, 8 or 9 nodes");
            return;
        }
        const bool plane = traitsOf(*kind).dimension == 2;
        const std::int32_t tag = tagComment_ > 0 ? tagComment_
                                 : set.empty()   ? kNoSet
                                                 : (plane ? regions_ : boundaries_).of(set);
        const std::uint32_t first = static_cast<std::uint32_t>(builder_.elements.size());
        while (more()) {
            std::int64_t number = 0;
            if (!scanner_.integer(number, 1, kGreatest, {"the number of an element"})) {
                return;
            }
            const Expect expect{"element", static_cast<std::uint64_t>(number)};
            if (!plane) {
                builder_.readEdge(scanner_, *kind, tag, expect, *kind == CellKind::Edge3 ? kAbaqusEdge3 : kSameOrder);
            } else if (builder_.readElement(scanner_, *kind, tag, expect)) {
                numbers_.push_back(number);
                ownSet_.push_back(!set.empty());
            }
        }
        if (plane && !set.empty()) {
            std::vector<std::uint32_t> &members = sets_[upperCase(set)];
            for (std::uint32_t e = first; e < builder_.elements.size(); ++e) {
                members.push_back(e);
            }
        }
        table_ = NodeTable();
    }

    /// Index of an element by its number, or kNoIndex.
    std::uint32_t element(std::int64_t number) {
        if (table_.size() != numbers_.size()) {
            table_ = NodeTable();
            for (const std::int64_t n : numbers_) {
                table_.add(n);
            }
            table_.finish();
        }
        return table_.find(number);
    }

    /// A set listed after the elements is the region of those without one, unless it only serves a surface.
    void elementSet(const Keyword &keyword) {
        const std::string name = parameter(keyword, "ELSET");
        const bool generate = keyword.parameters.contains("GENERATE");
        std::vector<std::uint32_t> members;
        std::size_t others = 0;
        while (more()) {
            std::int64_t from = 0, to = 0, step = 1;
            const std::string_view word = scanner_.peek();
            if (word.front() < '0' || word.front() > '9') {
                const std::size_t place = scanner_.offset();
                const std::string given = upperCase(scanner_.word());
                const auto other = sets_.find(given);
                if (other != sets_.end()) {
                    members.insert(members.end(), other->second.begin(), other->second.end());
                } else {
                    scanner_.source().note("element-set",
                                           "the set " + inQuotes(given) +
                                               " is left out of another set: it holds no plane elements so far",
                                           place);
                }
                continue;
            }
            const Expect expect{"an element of a set"};
            if (!scanner_.integer(from, 1, kGreatest, expect) ||
                (generate && (!scanner_.integer(to, from, kGreatest, expect) ||
                              !scanner_.integer(step, 1, kGreatest, {"the step of a set"})))) {
                return;
            }
            to = generate ? std::min<std::int64_t>(to, from + step * static_cast<std::int64_t>(numbers_.size())) : from;
            for (std::int64_t number = from; number <= to; number += step) {
                const std::uint32_t e = element(number);
                if (e != kNoIndex) {
                    members.push_back(e);
                } else {
                    ++others;
                }
            }
            if (members.size() > 4 * numbers_.size() + 1000) {
                scanner_.fail(scanner_.offset(), "bad-count", "the set has more members than there are elements");
                return;
            }
        }
        if (!keyword.parameters.contains("INTERNAL")) {
            makeRegion(name, members, others, keyword.offset);
        }
        sets_[upperCase(name)] = std::move(members);
    }

    /// `others`: number of members that are no plane elements.
    void makeRegion(const std::string &name, const std::vector<std::uint32_t> &members, std::size_t others,
                    std::size_t place) {
        const auto note = [&](const std::string &message, std::size_t count) {
            if (count > 0) {
                scanner_.source().note("element-set", message, place, count);
            }
        };
        std::size_t ofOwn = 0, again = 0;
        for (const std::uint32_t e : members) {
            std::int32_t &region = builder_.elements.regions[e];
            if (ownSet_[e]) {
                ++ofOwn;
                continue;
            }
            again += region != kNoSet && region != regions_.of(name) ? 1 : 0;
            region = regions_.of(name);
        }
        note("the region of elements in several sets is the last one listed", again);
        note("the set " + inQuotes(name) + " makes no region of elements that have a set of their own",
             upperCase(name) == "EALL" ? 0 : ofOwn); // EALL: all elements, as our writer lists them
        note("elements in the set " + inQuotes(name) + " that are no plane elements are left out of it", others);
    }

    /// Gives elements and lines outside every set a free tag each.
    void tagTheRest() {
        for (std::int32_t &region : builder_.elements.regions) {
            region = region == kNoSet ? regions_.of({}) : region;
        }
        for (TaggedEdge &edge : builder_.mesh.edges) {
            edge.tag = edge.tag == kNoSet ? boundaries_.of({}) : edge.tag;
        }
    }

    /// Notes the sets of nodes, except those beside a surface, as our writer writes them.
    void noteNodeSets() {
        for (const auto &[name, place] : nodeSets_) {
            if (!surfaces_.contains("S_" + name)) {
                scanner_.source().note("node-set", "sets of nodes are ignored; boundary parts are surfaces of elements",
                                       place);
            }
        }
    }

    void points() {
        while (more()) {
            builder_.readPoint(scanner_, pointComment_, {"a point"});
        }
    }

    void surface(const Keyword &keyword) {
        const std::string type = upperCase(parameter(keyword, "TYPE"));
        const bool sides = type.empty() || type == "ELEMENT";
        if (!sides) {
            scanner_.source().note("node-surface", "surfaces of nodes are ignored", keyword.offset);
            while (more()) {
                line();
            }
            return;
        }
        surfaces_.insert(upperCase(parameter(keyword, "NAME")));
        const std::int32_t tag = tagComment_ > 0 ? tagComment_ : boundaries_.of(parameter(keyword, "NAME"));
        while (more()) {
            const std::size_t place = scanner_.offset();
            const std::string member = upperCase(scanner_.word());
            const std::string side = upperCase(scanner_.word());
            if (side.size() != 2 || side[0] != 'S' || side[1] < '1' || side[1] > '4') {
                scanner_.fail(place, "bad-side", "expected an element or element set and a side S1, S2, S3 or S4");
                return;
            }
            const auto k = static_cast<std::size_t>(side[1] - '1');
            const auto set = sets_.find(member);
            if (set != sets_.end()) {
                for (const std::uint32_t e : set->second) {
                    addSide(e, k, tag, place);
                }
                continue;
            }
            TextScanner digits = scanner_.part(place, place + member.size());
            std::int64_t number = 0;
            const std::uint32_t e =
                digits.integer(number, 1, kGreatest, {"an element of a surface"}) ? element(number) : kNoIndex;
            if (e == kNoIndex) {
                scanner_.fail(place, "bad-index",
                              "the surface refers to element " + inQuotes(member) + ", which does not exist");
                return;
            }
            addSide(e, k, tag, place);
        }
    }

    void addSide(std::uint32_t e, std::size_t k, std::int32_t tag, std::size_t place) {
        const CellTraits &traits = traitsOf(builder_.elements.kindOf(e));
        if (k >= traits.corners) {
            scanner_.fail(place, "bad-side", "element " + std::to_string(numbers_[e]) + ", a triangle, has no side S4");
            return;
        }
        const std::span<const NodeId> nodes = builder_.elements.nodesOf(e);
        builder_.mesh.edges.push_back(
            {nodes[k], nodes[(k + 1) % traits.corners], tag, traits.order == 2 ? nodes[traits.corners + k] : kNoNode});
    }

    /// Sets group elements by region; sorting by number restores the order of the writer.
    void sortElements() {
        if (std::is_sorted(numbers_.begin(), numbers_.end())) {
            return;
        }
        std::vector<std::uint32_t> order(numbers_.size());
        std::iota(order.begin(), order.end(), 0U);
        std::stable_sort(order.begin(), order.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return numbers_[a] < numbers_[b]; });
        builder_.elements.arrange(order);
        std::sort(numbers_.begin(), numbers_.end());
    }

    TextScanner scanner_;
    PlanarMeshBuilder builder_;
    std::size_t lineOffset_ = 0;
    bool nodesFinished_ = false; ///< the second pass reads everything else
    bool hasElements_ = false;
    int parts_ = 0;
    std::int32_t tagComment_ = 0, pointComment_ = 0;
    std::vector<std::int64_t> numbers_; ///< of the elements
    std::vector<bool> ownSet_;          ///< the element was given its set with *ELEMENT
    NodeTable table_;
    std::map<std::string, std::vector<std::uint32_t>> sets_;
    std::vector<std::pair<std::string, std::size_t>> nodeSets_; ///< names in upper case, and their places
    std::set<std::string> surfaces_;                            ///< names in upper case
    TagAllocator boundaries_, regions_;
};

} // namespace

bool looksLikeAbaqus(std::string_view head) {
    const std::string text = upperCase(head);
    return text.starts_with("*HEADING") || text.starts_with("*NODE") || text.find("\n*NODE") != std::string::npos;
}

Result<Mesh> readAbaqus(const SourceText &source) {
    return AbaqusReader(source).read();
}

} // namespace forefront
