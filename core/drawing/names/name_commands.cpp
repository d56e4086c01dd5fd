#include "core/drawing/names/name_commands.hpp"

#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

namespace forefront {
namespace {

using Names = std::map<std::int32_t, std::string>;

/// The tags of a part, and the tags in use outside it.
struct TagUse {
    std::set<std::int32_t> inside, outside;
};

TagUse tagUse(const Document &document, const BoundaryPart &part) {
    TagUse use;
    for (const auto &shape : document.shapes) {
        if (shape->construction) {
            continue;
        }
        const bool whole = part.shapes.contains(shape->id);
        const std::size_t segments = taggedSegments(*shape);
        for (std::uint32_t k = 0; k < segments; ++k) {
            const bool in = whole || part.segments.contains({shape->id, k});
            (in ? use.inside : use.outside).insert(segmentTag(*shape, k));
        }
        if (segments == 0) {
            (whole ? use.inside : use.outside).insert(shape->tag);
        }
    }
    return use;
}

std::optional<std::int32_t> tagOf(const Names &names, const std::string &name) {
    const auto found =
        std::find_if(names.begin(), names.end(), [&](const auto &entry) { return entry.second == name; });
    return found != names.end() ? std::optional(found->first) : std::nullopt;
}

} // namespace

std::optional<std::int32_t> boundaryTagNamed(const Document &document, const std::string &name) {
    if (const std::optional<std::int32_t> named = tagOf(document.boundaryNames, name)) {
        return named;
    }
    const std::vector<std::int32_t> tags = boundaryTags(document);
    const auto found = std::find_if(
        tags.begin(), tags.end(), [&](std::int32_t tag) { return boundaryName(document.boundaryNames, tag) == name; });
    return found != tags.end() ? std::optional(*found) : std::nullopt;
}

std::int32_t freeBoundaryTag(const Document &document) {
    const std::vector<std::int32_t> tags = boundaryTags(document);
    std::int32_t last = tags.empty() ? 0 : tags.back();
    // A deleted part may have left its size.
    const auto &sizes = document.spacing.partSizes;
    const auto &counts = document.elementCounts;
    last = sizes.empty() ? last : std::max(last, sizes.rbegin()->first);
    last = counts.empty() ? last : std::max(last, counts.rbegin()->first);
    for (const LayerSpec &layer : document.layers) {
        last = std::max(last, layer.tag);
    }
    for (const PeriodicSpec &spec : document.periodic) {
        last = std::max({last, spec.from, spec.to});
    }
    for (const std::int32_t tag : document.cracks) {
        last = std::max(last, tag);
    }
    for (const std::int32_t tag : document.openBoundaries) {
        last = std::max(last, tag);
    }
    for (const StripSpec &spec : document.strips) {
        last = std::max(last, spec.tag);
    }
    return last < std::numeric_limits<std::int32_t>::max() ? last + 1 : last;
}

Result<Document> nameBoundaryPart(const Document &document, const BoundaryPart &part, const std::string &name) {
    const TagUse use = tagUse(document, part);
    if (use.inside.empty()) {
        return error("not-possible", "nothing that can be named is selected");
    }
    const std::int32_t first = *use.inside.begin();
    const bool ownTag = use.inside.size() == 1 && !use.outside.contains(first);
    const std::optional<std::int32_t> known = name.empty() ? std::nullopt : tagOf(document.boundaryNames, name);
    const std::int32_t tag = known ? *known : ownTag ? first : freeBoundaryTag(document);
    Result<Document> next = setShapeTag(document, part.shapes, tag);
    if (next) {
        next = setSegmentTag(*next, part.segments, tag);
    }
    return next && !known ? setBoundaryName(*next, tag, name) : next;
}

Result<Document> renameBoundaryTag(const Document &document, std::int32_t tag, const std::string &name) {
    const std::optional<std::int32_t> known = name.empty() ? std::nullopt : tagOf(document.boundaryNames, name);
    if (!known || *known == tag) {
        return setBoundaryName(document, tag, name);
    }
    BoundaryPart all;
    for (const auto &shape : document.shapes) {
        if (shape->segmentTags.empty() && shape->tag == tag) {
            all.shapes.insert(shape->id);
        }
        for (std::uint32_t k = 0; k < shape->segmentTags.size(); ++k) {
            if (segmentTag(*shape, k) == tag) {
                all.segments.insert({shape->id, k});
            }
        }
    }
    Document merged = document;
    merged.boundaryNames.erase(tag);
    merged.spacing.partSizes.erase(tag);
    merged.elementCounts.erase(tag);
    std::erase_if(merged.layers, [&](const LayerSpec &layer) { return layer.tag == tag; });
    std::erase_if(merged.periodic, [&](const PeriodicSpec &spec) { return spec.from == tag || spec.to == tag; });
    std::erase(merged.cracks, tag);
    std::erase(merged.openBoundaries, tag);
    std::erase_if(merged.strips, [&](const StripSpec &spec) { return spec.tag == tag; });
    return all.shapes.empty() && all.segments.empty() ? merged : nameBoundaryPart(merged, all, name);
}

Result<Document> nameRegionOf(const Document &document, std::size_t marker, const std::string &name) {
    if (marker >= document.regionMarkers.size()) {
        return error("no-such-marker", "region marker not found");
    }
    const std::int32_t before = document.regionMarkers[marker].tag;
    const auto sharing = std::count_if(document.regionMarkers.begin(), document.regionMarkers.end(),
                                       [&](const MarkedRegion &other) { return other.tag == before; });
    const bool ownTag = sharing == 1 && before != 1; // 1 is also the tag of all faces without a marker
    const std::optional<std::int32_t> known = name.empty() ? std::nullopt : tagOf(document.regionNames, name);
    const std::int32_t tag = known ? *known : ownTag ? before : freeRegionTag(document);
    const Result<Document> next = setRegionTag(document, marker, tag);
    return next && !known ? setRegionName(*next, tag, name) : next;
}

} // namespace forefront
