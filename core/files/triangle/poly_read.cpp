#include "core/engine/base/number_text.hpp"
#include "core/files/common/names.hpp"
#include "core/files/common/node_table.hpp"
#include "core/files/common/raise_tags.hpp"
#include "core/files/source/companion.hpp"
#include "core/files/text/text_scanner.hpp"
#include "core/files/triangle/triangle.hpp"
#include "core/files/triangle/triangle_nodes.hpp"

#include <limits>
#include <string>
#include <system_error>

namespace forefront {

namespace {

constexpr std::int64_t kGreatestTag = std::numeric_limits<std::int32_t>::max();

class PolyReader {
  public:
    explicit PolyReader(const SourceText &source) : source_(source), scanner_(source, '#') {}

    Result<DomainFile> read() {
        domain_.insideRule = InsideRule::HoleMarkers;
        if (!nodes() || !segments() || !holes() || !regions()) {
            return scanner_.ok() ? faults_ : scanner_.faults();
        }
        noteLinesAfter();
        isolatedNodes();
        openChainsAsConstraints();
        TagNames names = readNameComments(source_.text, "#");
        domain_.boundaryNames = std::move(names.boundary);
        for (auto &[tag, name] : names.region) {
            domain_.regionNames.insert_or_assign(tag, name);
        }
        raiseTags(domain_, source_);
        return std::move(file_);
    }

  private:
    bool nodes() {
        TriangleNodes nodes;
        if (!nodes.read(scanner_, true)) {
            return false;
        }
        if (nodes.places.empty()) {
            const auto companion = readCompanion(source_, ".node");
            if (!companion) {
                faults_ = companion.faults();
                return false;
            }
            TextScanner scanner((*companion)->source, '#');
            if (!nodes.read(scanner, false)) {
                faults_ = scanner.faults();
                return false;
            }
        }
        if (nodes.attributes > 0) {
            source_.note("node-attributes", "attributes of nodes are ignored", 0, nodes.places.size());
        }
        domain_.nodes = std::move(nodes.places);
        nodeMarkers_ = std::move(nodes.markers);
        table_ = std::move(nodes.table);
        for (std::size_t k = 0; k < table_.size() && source_.origin != nullptr; ++k) {
            note(DomainPartKind::Node, k < nodes.offsets.size() ? nodes.offsets[k] : PartOrigin::kNowhere,
                 table_.number(k));
        }
        return true;
    }

    bool segments() {
        TextScanner line = scanner_;
        std::size_t count = 0;
        std::int64_t markers = 0;
        if (!header(line, count, "the number of segments", 4)) {
            return scanner_.fail(line);
        }
        if (!line.atEnd() && !line.integer(markers, 0, 1, {"the number of markers of a segment"})) {
            return scanner_.fail(line);
        }
        domain_.segments.reserve(count);
        for (std::size_t k = 0; k < count; ++k) {
            DomainSegment segment;
            std::int64_t number = 0, tag = markers == 1 ? 0 : 1;
            const Expect expect{"segment", k + 1};
            if (!nextLine(line, expect)) {
                return scanner_.fail(line);
            }
            const std::size_t begin = line.offset();
            if (!line.integer(number, 0, kGreatestTag, expect) || !nodeIndex(line, segment.a, expect) ||
                !nodeIndex(line, segment.b, expect)) {
                return scanner_.fail(line);
            }
            note(DomainPartKind::Segment, begin, number);
            if (markers == 1 && !line.atEnd() &&
                !line.integer(tag, -kGreatestTag, kGreatestTag, {"the marker of segment", k + 1})) {
                return scanner_.fail(line);
            }
            segment.tag = static_cast<std::int32_t>(tag);
            domain_.segments.push_back(segment);
        }
        return true;
    }

    bool holes() {
        TextScanner line = scanner_;
        std::size_t count = 0;
        if (!header(line, count, "the number of holes", 5)) {
            return scanner_.fail(line);
        }
        for (std::size_t k = 0; k < count; ++k) {
            Vec2 at;
            if (!numberedPlace(line, at, DomainPartKind::HoleMarker, {"hole", k + 1})) {
                return scanner_.fail(line);
            }
            domain_.holeMarkers.push_back(at);
        }
        return true;
    }

    /// Reads "number x y attribute [maximum area]". Attributes are numbers: integers of at least 1 are tags;
    /// raiseTags() gives others a free tag and their digits as name.
    bool regions() {
        if (scanner_.atEnd()) {
            return true;
        }
        TextScanner line = scanner_;
        std::size_t count = 0;
        if (!header(line, count, "the number of regions", 7)) {
            return scanner_.fail(line);
        }
        AttributeTags tags(domain_.regionNames, TagKind::Region);
        for (std::size_t k = 0; k < count; ++k) {
            RegionMarker marker;
            double attribute = 0.0, maxArea = 0.0;
            if (!numberedPlace(line, marker.at, DomainPartKind::RegionMarker, {"region", k + 1}) ||
                !line.real(attribute, {"the attribute of region", k + 1}) ||
                (!line.atEnd() && !line.real(maxArea, {"the maximum area of region", k + 1}))) {
                return scanner_.fail(line);
            }
            marker.tag = tags.of(attribute);
            domain_.regionMarkers.push_back(marker);
            if (maxArea > 0.0) { // Triangle writes -1 for "no limit"
                file_.spacing.placed.regions.push_back({.at = marker.at, .maxArea = maxArea});
            }
        }
        return true;
    }

    /// Notes lines after the last section, which may be longer than it announces.
    void noteLinesAfter() {
        TextScanner line = scanner_;
        std::size_t lines = 0, place = 0;
        while (scanner_.nextLine(line)) {
            place = lines++ == 0 ? line.offset() : place;
        }
        if (lines > 0) {
            source_.note("more-lines", "lines after the last section are ignored; its number of items may be wrong",
                         place, lines);
        }
    }

    bool header(TextScanner &line, std::size_t &count, const char *what, std::size_t bytes) {
        if (!nextLine(line, {what})) {
            return false;
        }
        // The items follow the line, so the count is checked against the rest of the file.
        TextScanner whole = scanner_.part(line.offset(), source_.text.size());
        if (!whole.count(count, bytes, {what})) {
            return line.fail(whole);
        }
        line.seek(whole.offset());
        return true;
    }

    bool nextLine(TextScanner &line, Expect expect) {
        return scanner_.nextLine(line) ||
               line.fail(scanner_.offset(), "bad-syntax", "expected " + expect.words() + ", found the end of the file");
    }

    bool numberedPlace(TextScanner &line, Vec2 &at, DomainPartKind kind, Expect expect) {
        std::int64_t number = 0;
        if (!nextLine(line, expect)) {
            return false;
        }
        const std::size_t begin = line.offset();
        if (!line.integer(number, 0, kGreatestTag, expect)) {
            return false;
        }
        note(kind, begin, number);
        return line.real(at.x, expect) && line.real(at.y, expect);
    }

    void note(DomainPartKind kind, std::size_t offset, std::int64_t number) {
        if (source_.origin != nullptr) {
            source_.origin->of(kind).push_back({offset, number});
        }
    }

    bool nodeIndex(TextScanner &line, std::uint32_t &index, Expect expect) {
        std::int64_t number = 0;
        if (!line.integer(number, 0, kGreatestTag, expect)) {
            return false;
        }
        index = table_.find(number);
        return index != kNoIndex ||
               line.fail(line.offset(), "bad-index",
                         expect.words() + " refers to node " + std::to_string(number) + ", which does not exist");
    }

    /// Turns nodes that no segment uses into constraint points, as Triangle does.
    void isolatedNodes() {
        degrees_.assign(domain_.nodes.size(), 0);
        for (const DomainSegment &segment : domain_.segments) {
            ++degrees_[segment.a];
            ++degrees_[segment.b];
        }
        std::size_t unusedMarkers = 0;
        for (std::uint32_t n = 0; n < degrees_.size(); ++n) {
            const bool marked = nodeMarkers_[n] != 0 && nodeMarkers_[n] != 1;
            unusedMarkers += degrees_[n] > 0 && marked ? 1 : 0;
            if (degrees_[n] == 0) {
                domain_.points.push_back({n, nodeMarkers_[n]});
                if (source_.origin != nullptr) {
                    source_.origin->of(DomainPartKind::ConstraintPoint)
                        .push_back(source_.origin->of(DomainPartKind::Node)[n]);
                }
            }
        }
        if (unusedMarkers > 0) {
            source_.note("node-markers", "markers of nodes on segments are ignored: the segments' markers are the tags",
                         0, unusedMarkers);
        }
    }

    /// Turns open chains into constraints: segments with free ends inside are legal in a .poly file and bound nothing.
    /// A file with nothing but open chains is left unchanged, so that `validate` reports the gaps.
    void openChainsAsConstraints() {
        std::vector<std::uint32_t> offsets(domain_.nodes.size() + 1, 0);
        for (std::size_t n = 0; n < degrees_.size(); ++n) {
            offsets[n + 1] = offsets[n] + degrees_[n];
        }
        std::vector<std::uint32_t> around(offsets.back());
        std::vector<std::uint32_t> filled(offsets.begin(), offsets.end() - 1);
        for (std::uint32_t s = 0; s < domain_.segments.size(); ++s) {
            around[filled[domain_.segments[s].a]++] = s;
            around[filled[domain_.segments[s].b]++] = s;
        }
        std::vector<bool> open(domain_.segments.size(), false);
        std::size_t openCount = 0;
        for (std::uint32_t start = 0; start < degrees_.size(); ++start) {
            for (std::uint32_t node = start; degrees_[node] == 1;) {
                std::uint32_t s = around[offsets[node]];
                for (std::uint32_t k = offsets[node]; open[s]; ++k) {
                    s = around[k];
                }
                open[s] = true;
                ++openCount;
                --degrees_[node];
                node = domain_.segments[s].a == node ? domain_.segments[s].b : domain_.segments[s].a;
                --degrees_[node];
            }
        }
        for (std::size_t s = 0; s < open.size() && openCount < open.size(); ++s) {
            if (open[s]) {
                domain_.segments[s].role = SegmentRole::Constraint;
            }
        }
    }

    const SourceText &source_;
    TextScanner scanner_;
    Diagnostics faults_;
    DomainFile file_;
    Domain &domain_ = file_.domain;
    NodeTable table_;
    std::vector<std::int32_t> nodeMarkers_;
    std::vector<std::uint32_t> degrees_;
};

} // namespace

std::vector<std::filesystem::path> filesBesidePoly(const std::filesystem::path &poly) {
    std::filesystem::path nodes = poly;
    nodes.replace_extension(".node");
    std::error_code none;
    if (!std::filesystem::is_regular_file(poly, none) || !std::filesystem::is_regular_file(nodes, none)) {
        return {};
    }
    const Result<std::string> bytes = readFileBytes(poly, ImportOptions().maxBytes);
    if (!bytes) {
        return {};
    }
    const SourceText source{*bytes, poly.string(), poly, {}};
    TextScanner scanner(source, '#');
    std::int64_t count = -1;
    const bool elsewhere = scanner.integer(count, 0, 0, {"the number of nodes"});
    return elsewhere ? std::vector{nodes} : std::vector<std::filesystem::path>();
}

Result<DomainFile> readPoly(const SourceText &source) {
    return PolyReader(source).read();
}

} // namespace forefront
