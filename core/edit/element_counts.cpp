#include "core/edit/element_counts.hpp"

#include "core/edit/name_commands.hpp"
#include "core/edit/region_commands.hpp"
#include "core/edit/shape_commands.hpp"
#include "core/edit/shape_geometry.hpp"
#include "core/edit/spacing_commands.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace forefront {
namespace {

constexpr double kSameCount = 1e-9; ///< relative; lengths of curves are known to about 12 digits

/// Returns the mean distance of a segment from the chords that stand for it. The size of a boundary part holds at the
/// chords and grows away from them, so that on the curve it is larger by the growth times this distance.
double meanGap(const Document &document, const Shape &shape, std::uint32_t part) {
    const Outline outline = outlineOf(shape);
    const Chords chords = chordsOf(shape, outline, document.circleTolerance);
    double sum = 0.0, total = 0.0;
    for (std::size_t k = 0; k < chords.size(); ++k) {
        const std::uint32_t segment = chords.segments[k];
        if (outline.part(segment) != part || !outline.isCurved(segment)) {
            continue;
        }
        constexpr double kMean = 2.0 / 3.0; // of a parabola, by its height
        const CurveStretch &stretch = chords.stretches[k];
        const Vec2 middle = outline.curve(segment).point(0.5 * (stretch.t0 + stretch.t1));
        const double span = distance(chords.from(k), chords.to(k));
        sum += kMean * span * distance(middle, midpoint(chords.from(k), chords.to(k)));
        total += span;
    }
    return total > 0.0 ? sum / total : 0.0;
}

/// Segments of one tag, length and distance from their chords.
struct Alike {
    std::int32_t tag = 0;
    double length = 0.0, gap = 0.0;
    std::set<SegmentRef> segments;
};

Result<std::vector<Alike>> sorted(const Document &document, const std::set<SegmentRef> &segments) {
    std::vector<Alike> groups;
    for (const SegmentRef segment : segments) {
        const Shape *const shape = findShape(document, segment.shape);
        if (shape == nullptr || segment.segment >= taggedSegments(*shape)) {
            return error("no-such-segment", "segment not found");
        }
        const std::optional<double> length = countableLength(*shape, segment.segment);
        if (!length || !(*length > 0.0)) {
            return error("not-possible", "elements can be counted along a single line or curve only");
        }
        const std::int32_t tag = segmentTag(*shape, segment.segment);
        const double gap = meanGap(document, *shape, segment.segment);
        const auto known = std::find_if(groups.begin(), groups.end(), [&](const Alike &group) {
            return group.tag == tag && std::fabs(group.length - *length) <= kSameCount * *length &&
                   std::fabs(group.gap - gap) <= kSameCount * *length;
        });
        if (known != groups.end()) {
            known->segments.insert(segment);
        } else {
            groups.push_back({tag, *length, gap, {segment}});
        }
    }
    return groups;
}

/// Returns true if anything but these segments has a tag.
bool usedElsewhere(const Document &document, std::int32_t tag, const std::set<SegmentRef> &segments) {
    return std::any_of(document.shapes.begin(), document.shapes.end(), [&](const auto &shape) {
        const std::size_t parts = taggedSegments(*shape);
        bool used = parts == 0 && shape->tag == tag; // a point
        for (std::uint32_t k = 0; k < parts && !used; ++k) {
            used = segmentTag(*shape, k) == tag && !segments.contains({shape->id, k});
        }
        return used;
    });
}

/// Returns "NAME 2", or the first number above that is free.
std::string numberedName(const Document &document, const std::string &name) {
    for (int number = 2;; ++number) {
        std::string candidate = name + ' ' + std::to_string(number);
        const auto &names = document.boundaryNames;
        if (std::none_of(names.begin(), names.end(), [&](const auto &entry) { return entry.second == candidate; })) {
            return candidate;
        }
    }
}

Result<Document> withTag(const Document &document, const std::set<SegmentRef> &segments, std::int32_t tag) {
    std::set<std::uint32_t> whole;
    std::set<SegmentRef> parts;
    for (const SegmentRef segment : segments) {
        if (taggedSegments(*findShape(document, segment.shape)) == 1) {
            whole.insert(segment.shape);
        } else {
            parts.insert(segment);
        }
    }
    Result<Document> next = setShapeTag(document, whole, tag);
    return next ? setSegmentTag(*next, parts, tag) : next;
}

/// Gives segments a tag, named after the one that they had.
Result<Document> withNamedTag(const Document &document, const Alike &group, std::int32_t tag) {
    Result<Document> next = withTag(document, group.segments, tag);
    const auto name = document.boundaryNames.find(group.tag);
    if (next && name != document.boundaryNames.end()) {
        next = setBoundaryName(*next, tag, numberedName(document, name->second));
    }
    return next;
}

/// Gives segments a number of elements, or no size of their own. They get another tag if their tag is used elsewhere.
Result<Document> withCount(const Document &document, const Alike &group, std::optional<std::uint32_t> count) {
    const auto known = document.spacing.partSizes.find(group.tag);
    const bool sized = known != document.spacing.partSizes.end();
    if (!count && !sized) {
        return document;
    }
    std::optional<PartSize> size;
    if (count) {
        size = sized ? known->second : PartSize{};
        const double asked = group.length / *count;
        if (group.gap > 0.0) { // so steep a growth would make the sizes along the curve too uneven to be counted
            constexpr double kUneven = 0.03;
            size->growth = std::min(size->growth, kUneven * asked / group.gap);
        }
        size->size = asked - size->growth * group.gap;
    }
    if (!usedElsewhere(document, group.tag, group.segments)) {
        return setPartSize(document, group.tag, size);
    }
    const std::int32_t tag = freeBoundaryTag(document);
    const Result<Document> next = withNamedTag(document, group, tag);
    return next && size ? setPartSize(*next, tag, size) : next;
}

} // namespace

std::optional<double> countableLength(const Shape &shape, std::uint32_t part) {
    const Outline outline = outlineOf(shape);
    std::optional<double> length;
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        if (outline.part(k) == part) {
            if (length) {
                return std::nullopt;
            }
            length = outline.isCurved(k) ? outline.curve(k).length() : distance(outline.from(k), outline.to(k));
        }
    }
    return length;
}

std::optional<std::uint32_t> elementCount(const Document &document, SegmentRef segment) {
    const Shape *const shape = findShape(document, segment.shape);
    if (shape == nullptr || segment.segment >= taggedSegments(*shape)) {
        return std::nullopt;
    }
    const auto size = document.spacing.partSizes.find(segmentTag(*shape, segment.segment));
    const std::optional<double> length = countableLength(*shape, segment.segment);
    if (size == document.spacing.partSizes.end() || !length) {
        return std::nullopt;
    }
    const double gap = meanGap(document, *shape, segment.segment);
    const double exact = *length / (size->second.size + size->second.growth * gap), count = std::round(exact);
    const bool whole = count >= 1.0 && count <= kMaxElementCount && std::fabs(exact - count) <= kSameCount * count;
    return whole ? std::optional(static_cast<std::uint32_t>(count)) : std::nullopt;
}

Result<Document> setElementCount(const Document &document, const std::set<SegmentRef> &segments,
                                 std::optional<std::uint32_t> count) {
    if (count && (*count == 0 || *count > kMaxElementCount)) {
        return error("bad-number",
                     "expected 1 to " + std::to_string(kMaxElementCount) + " elements, got " + std::to_string(*count));
    }
    const Result<std::vector<Alike>> groups = sorted(document, segments);
    if (!groups) {
        return groups.faults();
    }
    Result<Document> next = document;
    for (const Alike &group : *groups) {
        next = withCount(*next, group, count);
        if (!next) {
            return next;
        }
    }
    return next;
}

} // namespace forefront
