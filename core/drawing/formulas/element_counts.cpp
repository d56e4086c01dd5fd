#include "core/drawing/formulas/element_counts.hpp"

#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/name_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/part_lengths.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/spacing/spec/spec_check.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

namespace forefront {
namespace {

constexpr double kSameLength = 1e-9; ///< relative; lengths of curves are known to about 12 digits

/// Segments of one tag and length.
struct Alike {
    std::int32_t tag = 0;
    double length = 0.0;
    std::set<SegmentRef> segments;
};

Result<std::vector<Alike>> sorted(const Document &document, const std::set<SegmentRef> &segments) {
    std::vector<Alike> groups;
    const Shape *shape = nullptr;
    std::vector<std::optional<double>> lengths;
    for (const SegmentRef segment : segments) {
        if (shape == nullptr || shape->id != segment.shape) {
            shape = findShape(document, segment.shape);
            lengths = shape != nullptr ? countableLengths(*shape) : std::vector<std::optional<double>>();
        }
        if (segment.segment >= lengths.size()) {
            return error("no-such-segment", "segment not found");
        }
        const double length = lengths[segment.segment].value_or(0.0);
        if (!(length > 0.0)) {
            return error("not-possible", "elements can be counted along a single line or curve only");
        }
        const std::int32_t tag = segmentTag(*shape, segment.segment);
        const auto known = std::find_if(groups.begin(), groups.end(), [&](const Alike &group) {
            return group.tag == tag && std::fabs(group.length - length) <= kSameLength * length;
        });
        if (known != groups.end()) {
            known->segments.insert(segment);
        } else {
            groups.push_back({tag, length, {segment}});
        }
    }
    return groups;
}

/// Returns true if a point, or a segment other than these, has the tag.
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

/// Returns the growth of a boundary part.
double growthOf(const Document &document, std::int32_t tag) {
    const auto counted = document.elementCounts.find(tag);
    if (counted != document.elementCounts.end()) {
        return counted->second.growth;
    }
    const auto sized = document.spacing.partSizes.find(tag);
    return sized != document.spacing.partSizes.end() ? sized->second.growth : PartSize{}.growth;
}

/// Gives segments a number of elements, or no size of their own. They get another tag if their tag is used elsewhere.
Result<Document> withCount(const Document &document, const Alike &group, std::optional<std::uint32_t> count) {
    if (!count && !document.elementCounts.contains(group.tag) && !document.spacing.partSizes.contains(group.tag)) {
        return document;
    }
    const auto elements = count ? std::optional(PartElements{*count, growthOf(document, group.tag)}) : std::nullopt;
    if (!usedElsewhere(document, group.tag, group.segments)) {
        return setPartElements(document, group.tag, elements);
    }
    const std::int32_t tag = freeBoundaryTag(document);
    const Result<Document> next = withNamedTag(document, group, tag);
    return next && elements ? setPartElements(*next, tag, elements) : next;
}

using ElementCounts = std::map<std::int32_t, PartElements>;

bool hasAnyTag(const Shape &shape, const ElementCounts &tags) {
    const std::vector<std::int32_t> &own = shape.segmentTags;
    return own.empty() ? tags.contains(shape.tag)
                       : std::any_of(own.begin(), own.end(), [&](auto tag) { return tags.contains(tag); });
}

/// Returns the segments with each of `tags`.
std::map<std::int32_t, PartSegments> partsOf(const Document &document, const ElementCounts &tags) {
    std::map<std::int32_t, PartSegments> parts;
    for (const auto &shape : document.shapes) {
        if (!hasAnyTag(*shape, tags)) {
            continue;
        }
        const std::vector<PartLength> lengths = partLengths(*shape);
        for (std::size_t k = 0; k < lengths.size(); ++k) {
            const std::int32_t tag = segmentTag(*shape, k);
            const double length = lengths[k].length;
            if (!tags.contains(tag) || !(length > 0.0) || !std::isfinite(length)) {
                continue;
            }
            PartSegments &all = parts[tag];
            all.shortest = all.count == 0 ? length : std::min(all.shortest, length);
            all.longest = std::max(all.longest, length);
            all.total += length;
            ++all.count;
        }
    }
    return parts;
}

std::map<std::int32_t, PartSize> sizesOf(const Document &document, const ElementCounts &tags) {
    std::map<std::int32_t, PartSize> sizes;
    for (const auto &[tag, parts] : partsOf(document, tags)) {
        const PartElements &elements = tags.at(tag);
        sizes[tag] = {parts.longest / elements.count, elements.growth};
    }
    return sizes;
}

} // namespace

std::vector<std::optional<double>> countableLengths(const Shape &shape) {
    std::vector<std::optional<double>> lengths;
    for (const PartLength &part : partLengths(shape)) {
        lengths.push_back(part.pieces == 1 ? std::optional(part.length) : std::nullopt);
    }
    return lengths;
}

std::optional<double> countableLength(const Shape &shape, std::uint32_t part) {
    const std::vector<std::optional<double>> lengths = countableLengths(shape);
    return part < lengths.size() ? lengths[part] : std::nullopt;
}

std::optional<std::uint32_t> elementCount(const Document &document, SegmentRef segment) {
    const Shape *const shape = findShape(document, segment.shape);
    if (shape == nullptr || segment.segment >= taggedSegments(*shape)) {
        return std::nullopt;
    }
    const auto elements = document.elementCounts.find(segmentTag(*shape, segment.segment));
    return elements != document.elementCounts.end() ? std::optional(elements->second.count) : std::nullopt;
}

Result<Document> setElementCount(const Document &document, const std::set<SegmentRef> &segments,
                                 std::optional<std::uint32_t> count) {
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

Result<Document> setPartElements(const Document &document, std::int32_t tag, std::optional<PartElements> elements) {
    Document next = document;
    next.spacing.partSizes.erase(tag);
    if (!elements) {
        next.elementCounts.erase(tag);
        return next;
    }
    if (elements->count == 0 || elements->count > kMaxElementCount) {
        return error("bad-number", "expected 1 to " + std::to_string(kMaxElementCount) + " elements, got " +
                                       std::to_string(elements->count));
    }
    Diagnostics faults;
    checkPartSizes({{tag, {1.0, elements->growth}}}, faults);
    if (!faults.empty()) {
        return faults;
    }
    next.elementCounts[tag] = *elements;
    return next;
}

std::map<std::int32_t, PartSegments> countedParts(const Document &document) {
    return partsOf(document, document.elementCounts);
}

std::vector<std::uint32_t> elementsOfParts(const Document &document, const Shape &shape,
                                           const std::map<std::int32_t, PartSegments> &counted) {
    if (counted.empty() || !hasAnyTag(shape, document.elementCounts)) {
        return {};
    }
    std::vector<std::uint32_t> elements;
    for (const PartLength &part : partLengths(shape)) {
        const std::int32_t tag = segmentTag(shape, elements.size());
        const auto found = counted.find(tag);
        double count = 0.0;
        if (found != counted.end() && part.pieces == 1) {
            count =
                std::max(1.0, std::round(document.elementCounts.at(tag).count * (part.length / found->second.longest)));
        }
        elements.push_back(static_cast<std::uint32_t>(count));
    }
    return elements;
}

std::optional<PartSize> elementSize(const Document &document, std::int32_t tag) {
    const auto elements = document.elementCounts.find(tag);
    if (elements == document.elementCounts.end()) {
        return std::nullopt;
    }
    const std::map<std::int32_t, PartSize> sizes = sizesOf(document, {*elements});
    return sizes.empty() ? std::nullopt : std::optional(sizes.begin()->second);
}

SpacingSpec rulesOf(const Document &document) {
    SpacingSpec spacing = document.spacing;
    for (const auto &[tag, size] : sizesOf(document, document.elementCounts)) {
        spacing.partSizes[tag] = size;
    }
    return spacing;
}

void carryElementCounts(const Document &before, Document &next) {
    constexpr double kSameTotal = 1e-3; // a repair moves nodes a little
    ElementCounts kept;
    std::set_intersection(next.elementCounts.begin(), next.elementCounts.end(), before.elementCounts.begin(),
                          before.elementCounts.end(), std::inserter(kept, kept.end()),
                          [](const auto &a, const auto &b) { return a.first < b.first; });
    if (kept.empty() || before.shapes == next.shapes) {
        return;
    }
    const std::map<std::int32_t, PartSegments> then = partsOf(before, kept), now = partsOf(next, kept);
    for (const auto &[tag, parts] : now) {
        const auto old = then.find(tag);
        if (old == then.end() || kept.at(tag) != before.elementCounts.at(tag) || parts.count == old->second.count ||
            std::fabs(parts.total - old->second.total) > kSameTotal * old->second.total) {
            continue;
        }
        const double count = std::round(kept.at(tag).count * (parts.longest / old->second.longest));
        next.elementCounts[tag].count =
            static_cast<std::uint32_t>(std::clamp(count, 1.0, static_cast<double>(kMaxElementCount)));
    }
}

} // namespace forefront
