#include "core/files/common/names.hpp"
#include "core/files/common/planar_mesh.hpp"
#include "core/files/common/raise_tags.hpp"
#include "core/files/common/tag_allocator.hpp"
#include "core/files/sms/two_dm.hpp"
#include "core/files/sms/two_dm_cards.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr std::int64_t kGreatestNumber = std::numeric_limits<std::int32_t>::max();

/// Reads cards, one on a line. Elements and node strings may come before the nodes, so theirs are looked up at the end.
class TwoDmReader {
  public:
    explicit TwoDmReader(const SourceText &source) : scanner_(source, '#') {}

    Result<MeshFields> read() {
        names_ = readNameComments(scanner_.source().text, "#");
        for (const auto &[tag, name] : names_.boundary) {
            boundaries_.reserve(tag);
        }
        TextScanner line = scanner_;
        while (scanner_.ok() && scanner_.nextLine(line)) {
            if (!card(line)) {
                scanner_.fail(line);
            }
        }
        if (scanner_.ok() && builder_.mesh.nodes.empty()) {
            scanner_.fail(scanner_.offset(), "bad-syntax", "the file has no nodes (ND)");
        }
        if (!builder_.finishNodes(scanner_) || !elements() || !endStrings()) {
            return scanner_.faults();
        }
        builder_.readPointComments(scanner_, "#");
        scanner_.source().numbered(PartNumbers(builder_.table.numbers()), builder_.elements.numbered(numbers_));
        builder_.findMiddles();
        MeshFields file;
        file.mesh = builder_.finish();
        file.mesh.boundaryNames = boundaries_.names();
        file.mesh.boundaryNames.insert(names_.boundary.begin(), names_.boundary.end());
        file.mesh.regionNames = std::move(names_.region);
        raiseTags(file.mesh, scanner_.source());
        if (std::any_of(elevations_.begin(), elevations_.end(), [](double z) { return z != 0.0; })) {
            file.fields.emplace("elevation", std::move(elevations_));
        }
        return file;
    }

  private:
    struct Item {
        CellKind kind;
        std::int64_t number;
        std::size_t offset; ///< of its nodes
    };
    /// A node string, with the places of its nodes and its tag.
    struct String {
        std::vector<std::pair<std::int64_t, std::size_t>> nodes;
        std::int32_t tag = 0;
    };

    bool card(TextScanner &line) {
        const std::size_t place = line.offset();
        const std::string_view word = line.word();
        const auto element = std::find_if(kTwoDmCards.begin(), kTwoDmCards.end(),
                                          [&](const TwoDmCard &each) { return each.name == word; });
        if (element != kTwoDmCards.end()) {
            std::int64_t number = 0;
            if (!line.integer(number, 0, kGreatestNumber, {"the number of an element"})) {
                return false;
            }
            items_.push_back({element->kind, number, line.offset()});
            return true;
        }
        if (word == "ND") {
            return node(line);
        }
        if (word == "NS") {
            return nodeString(line);
        }
        if (word == "NUM_MATERIALS_PER_ELEM") {
            return line.integer(materials_, 0, 1000, {"the number of materials"});
        }
        if (word == "E2L" || word == "E3L") {
            return line.fail(place, "unknown-element",
                             "line elements " + std::string(word) +
                                 " cannot be read; only E3T, E4Q, E6T, E8Q, E9Q, and node strings NS");
        }
        if (word != "MESH2D" && word != "MESHNAME") {
            scanner_.source().note("card", "card " + inQuotes(word) + " is ignored", place);
        }
        return true;
    }

    bool node(TextScanner &line) {
        std::int64_t number = 0;
        if (!line.integer(number, 0, kGreatestNumber, {"the number of a node"}) ||
            !builder_.readNode(line, number, 2)) {
            return false;
        }
        double z = 0.0;
        const bool read = line.atEnd() || line.real(z, {"the elevation of node", static_cast<std::uint64_t>(number)});
        elevations_.push_back(z);
        return read;
    }

    /// Reads a line of a node string, which ends at its negative node; its number and perhaps its name follow.
    bool nodeString(TextScanner &line) {
        if (!open_) {
            strings_.emplace_back();
            stringPlace_ = line.offset();
            open_ = true;
        }
        while (open_ && !line.atEnd()) {
            std::int64_t number = 0;
            const std::size_t place = line.offset();
            if (!line.integer(number, -kGreatestNumber, kGreatestNumber, {"a node of a node string"})) {
                return false;
            }
            strings_.back().nodes.emplace_back(std::abs(number), place);
            open_ = number >= 0;
        }
        return open_ || line.atEnd() || nameString(line);
    }

    bool nameString(TextScanner &line) {
        const char first = line.peek().front();
        if (first == '"' || ((first < '0' || first > '9') && first != '-')) {
            std::string_view name;
            if (!line.quotedWord(name, {"the name of a node string"})) {
                return false;
            }
            strings_.back().tag = boundaries_.of(cleanName(name));
        } else if (!readTag(line, strings_.back().tag, {"the number of a node string"})) {
            return false;
        } else {
            boundaries_.reserve(strings_.back().tag);
        }
        if (!line.atEnd()) {
            scanner_.source().note("node-string", "words after the number of a node string are ignored", line.offset());
        }
        return true;
    }

    bool elements() {
        const std::string_view text = scanner_.source().text;
        scanner_.seek(0); // the elements are read again, which can be cancelled, too
        for (const Item &item : items_) {
            if (!scanner_.proceed(item.offset)) {
                return false;
            }
            TextScanner line = scanner_.part(item.offset, std::min(text.find('\n', item.offset), text.size()));
            const CellTraits &traits = traitsOf(item.kind);
            const Expect expect{"element", static_cast<std::uint64_t>(item.number)};
            CellOrder order = kSameOrder;
            for (std::size_t k = 0; k < traits.nodes; ++k) {
                order[k] = twoDmNode(traits, k);
            }
            if (!builder_.readElement(line, item.kind, 1, expect, order) || !material(line, expect)) {
                return scanner_.fail(line);
            }
            numbers_.push_back(item.number);
        }
        return true;
    }

    /// The first material is the region.
    bool material(TextScanner &line, Expect expect) {
        if (line.atEnd() || materials_ == 0) {
            return true;
        }
        const std::size_t place = line.offset();
        if (!readTag(line, builder_.elements.regions.back(), expect)) {
            return false;
        }
        if (!line.atEnd()) {
            scanner_.source().note("materials", "materials of elements after the first are ignored", place);
        }
        return true;
    }

    /// Makes edges of the node strings.
    bool endStrings() {
        if (open_) {
            return scanner_.fail(stringPlace_, "bad-syntax", "the last node of the node string is not negative",
                                 "the file may have been cut short");
        }
        std::vector<std::uint8_t> middle(builder_.mesh.nodes.size(), 0);
        for (std::size_t e = 0; e < builder_.elements.size(); ++e) {
            const std::span<const NodeId> nodes = builder_.elements.nodesOf(e);
            for (const NodeId node : nodes.subspan(traitsOf(builder_.elements.kindOf(e)).corners)) {
                middle[index(node)] = 1;
            }
        }
        for (String &string : strings_) {
            string.tag = string.tag == 0 ? boundaries_.of("") : string.tag;
            if (!addEdges(string, middle)) {
                return false;
            }
        }
        return true;
    }

    bool addEdges(const String &string, const std::vector<std::uint8_t> &isMiddle) {
        std::vector<NodeId> nodes;
        for (const auto &[number, place] : string.nodes) {
            const std::uint32_t found = builder_.table.find(number);
            if (found == kNoIndex) {
                return scanner_.fail(place, "bad-index",
                                     "a node string refers to node " + std::to_string(number) +
                                         ", which does not exist");
            }
            nodes.push_back(NodeId{found});
        }
        if (nodes.size() == 1) {
            scanner_.source().note("node-string", "node strings of a single node are ignored",
                                   string.nodes.front().second);
        }
        for (std::size_t k = 0; k + 1 < nodes.size();) {
            const bool curved = k + 2 < nodes.size() && isMiddle[index(nodes[k + 1])] != 0;
            const std::size_t next = curved ? k + 2 : k + 1;
            const NodeId ends[] = {nodes[k], nodes[next]};
            if (!requireDistinct(scanner_, string.nodes[k].second, ends, {"a node string"})) {
                return false;
            }
            builder_.mesh.edges.push_back({nodes[k], nodes[next], string.tag, curved ? nodes[k + 1] : kNoNode});
            k = next;
        }
        return true;
    }

    TextScanner scanner_;
    PlanarMeshBuilder builder_;
    std::vector<Item> items_;
    std::vector<std::int64_t> numbers_;
    std::vector<String> strings_;
    std::vector<double> elevations_;
    std::int64_t materials_ = 1;
    std::size_t stringPlace_ = 0;
    bool open_ = false; ///< the last node string goes on
    TagAllocator boundaries_;
    TagNames names_;
};

} // namespace

bool looksLikeTwoDm(std::string_view head) {
    return head.find("MESH2D") != std::string_view::npos;
}

Result<MeshFields> readTwoDmFields(const SourceText &source) {
    return TwoDmReader(source).read();
}

Result<Mesh> readTwoDm(const SourceText &source) {
    Result<MeshFields> file = readTwoDmFields(source);
    return file ? Result<Mesh>(std::move(file->mesh)) : file.faults();
}

} // namespace forefront
