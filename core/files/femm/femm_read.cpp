#include "core/engine/base/letter_case.hpp"
#include "core/files/common/names.hpp"
#include "core/files/common/tag_allocator.hpp"
#include "core/files/femm/femm.hpp"
#include "core/files/femm/femm_parts.hpp"
#include "core/files/text/text_scanner.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

namespace {

constexpr double kFemmFineness = 2000.0;      ///< sizes of the drawing in the tolerance of chords
constexpr double kFemmArcFineness = 50.0;     ///< the same for the size of one arc
constexpr std::int64_t kMaxFemm = 1 << 30;    ///< counts and indices
constexpr std::int64_t kFemmDefaultLabel = 2; ///< flag of a block label

/// A segment or, with an angle, an arc, counter-clockwise from its first node to its second.
struct FemmSide {
    std::uint32_t a = 0, b = 0;
    double degrees = 0.0;
    std::int32_t tag = 1;
    std::size_t offset = 0;
};

/// A label that names the material of the face around it.
struct FemmLabel {
    Vec2 at;
    std::string material;
    double diameter = 0.0;  ///< of a circle of the maximum area of an element; 0 or less: none is given
    bool isDefault = false; ///< the material holds for faces without a label too
    std::size_t offset = 0;
};

class FemmReader {
  public:
    explicit FemmReader(const SourceText &source) : source_(source), scanner_(source) {
        file_.domain.insideRule = InsideRule::HoleMarkers;
    }

    Result<DomainFile> read() {
        TextScanner line = scanner_;
        while (scanner_.ok() && scanner_.nextLine(line)) {
            if (!section(line)) {
                return scanner_.ok() ? line.faults() : scanner_.faults();
            }
        }
        if (!scanner_.ok()) {
            return scanner_.faults();
        }
        addSides();
        if (domain_.segments.empty()) {
            return Diagnostics{faultAt(source_, 0, "empty-domain", "the problem has no segments and arcs")};
        }
        addLabels();
        settleFemmParts(source_, domain_, origin_, boundaries_.of({}));
        if (source_.origin != nullptr) {
            *source_.origin = std::move(origin_);
        }
        domain_.boundaryNames = boundaries_.names();
        domain_.regionNames = regions_.names();
        domain_.curveTolerance = source_.options.curveTolerance;
        return std::move(file_);
    }

  private:
    bool section(TextScanner line) {
        const std::string_view text = line.rest();
        const std::string key = lowerCase(text.substr(0, text.find(']')));
        const std::size_t value = text.find('=');
        if (key == "[pointprops") {
            return names("<pointname>", "<endpoint>", pointProperties_, text, line.offset());
        }
        if (key == "[bdryprops") {
            return names("<bdryname>", "<endbdry>", conditions_, text, line.offset());
        }
        if (key == "[blockprops") {
            return names("<blockname>", "<endblock>", materials_, text, line.offset());
        }
        if (key == "[lengthunits" && value != std::string_view::npos) {
            source_.note("femm-units", "the coordinates are " + lowerCase(cleanName(text.substr(value + 1))),
                         line.offset());
        }
        constexpr struct {
            const char *key;
            bool (FemmReader::*read)(TextScanner &, std::size_t);
        } kLists[] = {{"[numpoints", &FemmReader::node},
                      {"[numsegments", &FemmReader::segment},
                      {"[numarcsegments", &FemmReader::arc},
                      {"[numholes", &FemmReader::hole},
                      {"[numblocklabels", &FemmReader::label}};
        for (const auto &list : kLists) {
            if (key == list.key) {
                return items(list.read, text, line.offset());
            }
        }
        return true;
    }

    bool count(std::string_view text, std::size_t offset, std::size_t &value) {
        const std::size_t equals = text.find('=');
        const auto number =
            equals == std::string_view::npos ? std::nullopt : parseReal(trimmed(text.substr(equals + 1)));
        if (!number || !(*number >= 0.0) || *number > static_cast<double>(kMaxFemm)) {
            return scanner_.fail(offset, "bad-count", "expected a number of items after '=', found " + inQuotes(text));
        }
        value = static_cast<std::size_t>(*number);
        return true;
    }

    static std::string_view trimmed(std::string_view text) {
        constexpr std::string_view kBlanks = " \t\r";
        text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
        text.remove_suffix(text.size() - (text.find_last_not_of(kBlanks) + 1));
        return text;
    }

    /// Reads the names of a list of properties.
    bool names(std::string_view nameKey, std::string_view endKey, std::vector<std::string> &list, std::string_view text,
               std::size_t offset) {
        std::size_t wanted = 0, ended = 0;
        if (!count(text, offset, wanted)) {
            return false;
        }
        TextScanner line = scanner_;
        while (ended < wanted) {
            if (!scanner_.nextLine(line)) {
                return scanner_.fail(offset, "bad-count",
                                     "expected " + std::to_string(wanted) + " properties, found " +
                                         std::to_string(ended));
            }
            const std::string_view content = line.rest();
            const std::string lower = lowerCase(content);
            if (lower.starts_with(nameKey)) {
                const std::size_t open = content.find('"'), close = content.rfind('"');
                list.push_back(open < close ? cleanName(content.substr(open + 1, close - open - 1)) : std::string());
            } else if (lower.starts_with(endKey)) {
                ++ended;
                list.resize(ended); // one without a name
            }
        }
        return true;
    }

    bool items(bool (FemmReader::*item)(TextScanner &, std::size_t), std::string_view text, std::size_t offset) {
        std::size_t wanted = 0;
        if (!count(text, offset, wanted)) {
            return false;
        }
        for (std::size_t k = 0; k < wanted; ++k) {
            TextScanner line = scanner_;
            if (!scanner_.nextLine(line)) {
                return scanner_.fail(offset, "bad-count",
                                     "expected " + std::to_string(wanted) + " lines, found " + std::to_string(k));
            }
            if (!(this->*item)(line, k + 1)) {
                return scanner_.ok() ? scanner_.fail(line) : false;
            }
        }
        return true;
    }

    bool node(TextScanner &line, std::size_t number) {
        const std::size_t offset = line.offset();
        const Expect expect{"node", number};
        Vec2 at;
        std::int64_t property = 0;
        if (!line.real(at.x, {"x of node", number}) || !line.real(at.y, {"y of node", number}) ||
            (!line.atEnd() && !line.integer(property, 0, kMaxFemm, expect))) {
            return false;
        }
        const auto place = static_cast<std::size_t>(property);
        if (place > pointProperties_.size()) {
            return line.fail(offset, "bad-index",
                             expect.words() + " refers to point property " + std::to_string(property) +
                                 ", which does not exist");
        }
        if (place > 0) {
            domain_.points.push_back(
                {static_cast<std::uint32_t>(domain_.nodes.size()), boundaries_.of(pointProperties_[place - 1])});
        }
        domain_.nodes.push_back(at);
        record(DomainPartKind::Node, offset);
        return true;
    }

    /// Reads two nodes by their numbers, which begin at 0.
    bool ends(TextScanner &line, FemmSide &side, Expect expect) {
        side.offset = line.offset();
        for (std::uint32_t *end : {&side.a, &side.b}) {
            std::int64_t index = 0;
            const std::size_t offset = line.offset();
            if (!line.integer(index, 0, kMaxFemm, expect)) {
                return false;
            }
            if (static_cast<std::size_t>(index) >= domain_.nodes.size()) {
                return line.fail(offset, "bad-index",
                                 expect.words() + " refers to node " + std::to_string(index) +
                                     ", which does not exist");
            }
            *end = static_cast<std::uint32_t>(index);
        }
        return true;
    }

    /// Reads the number of a boundary condition, 0 for none.
    bool condition(TextScanner &line, FemmSide &side, Expect expect) {
        std::int64_t index = 0;
        if (!line.integer(index, 0, kMaxFemm, expect)) {
            return false;
        }
        const auto place = static_cast<std::size_t>(index);
        if (place > conditions_.size()) {
            return line.fail(side.offset, "bad-index",
                             expect.words() + " refers to boundary condition " + std::to_string(index) +
                                 ", which does not exist");
        }
        side.tag = boundaries_.of(place == 0 ? std::string() : conditions_[place - 1]);
        return true;
    }

    bool segment(TextScanner &line, std::size_t number) {
        FemmSide side;
        double size = 0.0;
        const Expect expect{"segment", number};
        if (!ends(line, side, expect) || !line.real(size, expect) || !condition(line, side, expect)) {
            return false;
        }
        if (size > 0.0) {
            source_.note("femm-sizes", "element sizes of segments are not used", side.offset);
        }
        sides_.push_back(side);
        return true;
    }

    bool arc(TextScanner &line, std::size_t number) {
        FemmSide side;
        double step = 0.0;
        const Expect expect{"arc", number};
        if (!ends(line, side, expect) || !line.real(side.degrees, expect) || !line.real(step, expect) ||
            !condition(line, side, expect)) {
            return false;
        }
        if (!(side.degrees > 0.0 && side.degrees < 360.0)) {
            return line.fail(side.offset, "bad-value",
                             expect.words() + " needs an angle above 0 and below 360 degrees");
        }
        sides_.push_back(side);
        return true;
    }

    bool hole(TextScanner &line, std::size_t number) {
        const std::size_t offset = line.offset();
        Vec2 at;
        if (!line.real(at.x, {"x of hole", number}) || !line.real(at.y, {"y of hole", number})) {
            return false;
        }
        domain_.holeMarkers.push_back(at);
        record(DomainPartKind::HoleMarker, offset);
        return true;
    }

    /// Reads a block label: its place, the number of its material and the diameter of a circle of its maximum area.
    bool label(TextScanner &line, std::size_t number) {
        const std::size_t offset = line.offset();
        const Expect expect{"block label", number};
        Vec2 at;
        std::int64_t material = 0;
        double diameter = 0.0;
        if (!line.real(at.x, expect) || !line.real(at.y, expect) || !line.integer(material, -1, kMaxFemm, expect) ||
            !line.real(diameter, expect)) {
            return false;
        }
        if (material < 0) { // of older versions: no mesh
            domain_.holeMarkers.push_back(at);
            record(DomainPartKind::HoleMarker, offset);
            return true;
        }
        const auto place = static_cast<std::size_t>(material);
        if (place > materials_.size()) {
            return line.fail(offset, "bad-index",
                             expect.words() + " refers to material " + std::to_string(material) +
                                 ", which does not exist");
        }
        labels_.push_back({.at = at,
                           .material = place == 0 ? std::string() : materials_[place - 1],
                           .diameter = diameter,
                           .isDefault = isDefault(line),
                           .offset = offset});
        return true;
    }

    /// Returns true if a block label, whose first four numbers are read, also holds for faces without a label. Its
    /// flags are the last of nine numbers, or of six where the problem is not magnetic.
    static bool isDefault(TextScanner &line) {
        constexpr std::size_t kShort = 2, kLong = 5; // numbers left
        std::vector<double> left;
        for (double value = 0.0; left.size() < kLong && !line.atEnd() && line.real(value, {"block label"});) {
            left.push_back(value);
        }
        return (left.size() == kShort || left.size() == kLong) && left.back() >= 0.0 && left.back() < kMaxFemm &&
               (static_cast<std::int64_t>(left.back()) & kFemmDefaultLabel) != 0;
    }

    void addLabels() {
        // Faces without a marker have the first tag.
        std::stable_partition(labels_.begin(), labels_.end(), [](const FemmLabel &label) { return label.isDefault; });
        for (const FemmLabel &label : labels_) {
            domain_.regionMarkers.push_back({label.at, regions_.of(label.material)});
            record(DomainPartKind::RegionMarker, label.offset);
            if (label.diameter > 0.0) {
                const double area = 0.25 * std::numbers::pi * label.diameter * label.diameter;
                file_.spacing.placed.regions.push_back({.at = label.at, .maxArea = area});
            }
        }
    }

    void addSides() {
        const double size = domain_.bounds().diagonal(), wanted = source_.options.curveTolerance;
        for (const FemmSide &side : sides_) {
            const Vec2 a = domain_.nodes[side.a], b = domain_.nodes[side.b];
            const double chord = distance(a, b);
            if (side.degrees == 0.0 || chord == 0.0) {
                addSegment(side, side.a, side.b, {});
                continue;
            }
            const double sweep = side.degrees * std::numbers::pi / 180.0;
            const double height = 0.5 * chord / std::tan(0.5 * sweep); // of the centre over the chord
            const Vec2 along = (1.0 / chord) * (b - a);
            const Vec2 centre = 0.5 * (a + b) + height * Vec2{-along.y, along.x};
            const Vec2 u = a - centre;
            const Curve curve = Curve::arc(centre, u, {-u.y, u.x}, 0.0, sweep);
            const auto number = static_cast<std::uint32_t>(domain_.curves.size());
            domain_.curves.push_back(curve);
            const double tolerance =
                wanted > 0.0 ? wanted : std::min(size / kFemmFineness, curve.bounds().diagonal() / kFemmArcFineness);
            std::uint32_t last = side.a;
            double from = 0.0;
            for (const double to : curve.flatten(tolerance)) {
                std::uint32_t next = side.b;
                if (to < 1.0) {
                    next = static_cast<std::uint32_t>(domain_.nodes.size());
                    domain_.nodes.push_back(curve.point(to));
                    record(DomainPartKind::Node, side.offset);
                }
                addSegment(side, last, next, {number, from, to});
                last = next;
                from = to;
            }
        }
    }

    void addSegment(const FemmSide &side, std::uint32_t a, std::uint32_t b, const CurveStretch &stretch) {
        domain_.segments.push_back({a, b, side.tag, SegmentRole::Boundary, stretch});
        record(DomainPartKind::Segment, side.offset);
    }

    void record(DomainPartKind kind, std::size_t offset) { origin_.of(kind).push_back({offset, {}}); }

    const SourceText &source_;
    TextScanner scanner_;
    std::vector<std::string> pointProperties_, conditions_, materials_; ///< names, by number from 1 on
    std::vector<FemmSide> sides_;
    std::vector<FemmLabel> labels_;
    DomainOrigin origin_;
    TagAllocator boundaries_, regions_;
    DomainFile file_;
    Domain &domain_ = file_.domain;
};

} // namespace

Result<DomainFile> readFemm(const SourceText &source) {
    return FemmReader(source).read();
}

bool looksLikeFemm(std::string_view head) {
    const std::string lower = lowerCase(head);
    const auto has = [&lower](std::string_view key) { return lower.find(key) != std::string::npos; };
    const std::size_t start = lower.find_first_not_of(" \t\r\n");
    return start != std::string::npos && std::string_view(lower).substr(start).starts_with("[format]") &&
           (has("[problemtype]") || has("[lengthunits]"));
}

} // namespace forefront
