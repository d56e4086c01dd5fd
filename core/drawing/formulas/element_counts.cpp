#include "core/drawing/formulas/element_counts.hpp"

#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/shapes/part_lengths.hpp"
#include "core/drawing/shapes/segment_sizes.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/spacing/spec/spec_check.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

namespace forefront {
namespace {

/// Returns the growth of a boundary part.
double growthOf(const Document &document, std::int32_t tag) {
    const auto counted = document.elementCounts.find(tag);
    if (counted != document.elementCounts.end()) {
        return counted->second.growth;
    }
    const auto sized = document.spacing.partSizes.find(tag);
    return sized != document.spacing.partSizes.end() ? sized->second.growth : PartSize{}.growth;
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
        if (shape->construction || !hasAnyTag(*shape, tags)) {
            continue;
        }
        const std::vector<PartLength> lengths = partLengths(*shape);
        for (std::size_t k = 0; k < lengths.size(); ++k) {
            const std::int32_t tag = segmentTag(*shape, k);
            const double length = lengths[k].length;
            const bool own = shape->segmentSizes.contains(static_cast<std::uint32_t>(k));
            if (own || !tags.contains(tag) || !(length > 0.0) || !std::isfinite(length)) {
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

std::optional<std::uint32_t> elementCount(const Document &document, SegmentRef segment) {
    const Shape *const shape = findShape(document, segment.shape);
    if (shape == nullptr || segment.segment >= taggedSegments(*shape)) {
        return std::nullopt;
    }
    if (const auto own = shape->segmentSizes.find(segment.segment); own != shape->segmentSizes.end()) {
        return own->second.elements > 0 ? std::optional(own->second.elements) : std::nullopt;
    }
    const auto elements = document.elementCounts.find(segmentTag(*shape, segment.segment));
    return elements != document.elementCounts.end() ? std::optional(elements->second.count) : std::nullopt;
}

Result<Document> setElementCount(const Document &document, const std::set<SegmentRef> &segments,
                                 std::optional<std::uint32_t> count) {
    if (!count) {
        return setSegmentSize(document, segments, std::nullopt);
    }
    if (*count == 0 || *count > kMaxElementCount) {
        return error("bad-number",
                     "expected 1 to " + std::to_string(kMaxElementCount) + " elements, got " + std::to_string(*count));
    }
    std::map<SegmentRef, SegmentSize> sizes;
    const Shape *shape = nullptr;
    std::vector<std::optional<double>> lengths; // of its segments
    for (const SegmentRef segment : segments) { // in the order of their shapes
        if (shape == nullptr || shape->id != segment.shape) {
            shape = findShape(document, segment.shape);
            lengths = shape != nullptr ? countableLengths(*shape) : std::vector<std::optional<double>>();
        }
        if (shape == nullptr || segment.segment >= taggedSegments(*shape)) {
            return error("no-such-segment", "segment not found");
        }
        const bool listed = segment.segment < lengths.size();
        if (!listed || !(lengths[segment.segment].value_or(0.0) > 0.0)) {
            return error("not-possible", "elements can be counted along a single line or curve only");
        }
        const SegmentSize *const own = segmentSize(document, segment);
        const double growth = own != nullptr ? own->growth : growthOf(document, segmentTag(*shape, segment.segment));
        const ElementBias bias = own != nullptr ? own->bias : ElementBias{};
        sizes.emplace(segment, SegmentSize{.size = 0.0, .elements = *count, .growth = growth, .bias = bias});
    }
    return setSegmentSizes(document, sizes);
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
    if (shape.segmentSizes.empty() && (counted.empty() || !hasAnyTag(shape, document.elementCounts))) {
        return {};
    }
    std::vector<std::uint32_t> elements;
    for (const PartLength &part : partLengths(shape)) {
        const std::int32_t tag = segmentTag(shape, elements.size());
        const auto found = counted.find(tag);
        const auto own = shape.segmentSizes.find(static_cast<std::uint32_t>(elements.size()));
        double count = 0.0;
        if (own != shape.segmentSizes.end()) {
            count = part.pieces == 1 ? own->second.elements : 0.0;
        } else if (found != counted.end() && part.pieces == 1) {
            count =
                std::max(1.0, std::round(document.elementCounts.at(tag).count * (part.length / found->second.longest)));
        }
        elements.push_back(static_cast<std::uint32_t>(count));
    }
    return elements;
}

std::vector<PartSize> sizesOfParts(const Shape &shape) {
    std::vector<PartSize> sizes;
    if (shape.segmentSizes.empty()) {
        return sizes;
    }
    const std::vector<PartLength> parts = partLengths(shape);
    sizes.assign(parts.size(), PartSize{0.0, 0.0});
    for (const auto &[part, own] : shape.segmentSizes) {
        if (part < parts.size()) {
            const double size = own.elements > 0 ? parts[part].length / own.elements : own.size;
            sizes[part] = {size, own.growth};
        }
    }
    return sizes;
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
