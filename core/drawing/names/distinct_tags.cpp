#include "core/drawing/names/distinct_tags.hpp"

#include "core/drawing/names/name_commands.hpp"
#include "core/drawing/names/region_commands.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

using Names = std::map<std::int32_t, std::string>;
using Tags = std::map<std::int32_t, std::int32_t>; ///< new tags by old ones, where they differ

std::optional<std::string> nameIn(const Names &names, std::int32_t tag) {
    const auto found = names.find(tag);
    return found == names.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::int32_t> tagNamed(const Names &names, const std::optional<std::string> &name) {
    const auto found =
        std::find_if(names.begin(), names.end(), [&](const auto &each) { return name && each.second == *name; });
    return found == names.end() ? std::nullopt : std::optional(found->first);
}

/// Finds the new tags. `tags`, `names`: of the other drawing; `taken`, `known`: of the document, tags ascending.
/// `free`: a tag that both leave free, as all above it.
Tags distinctTags(const std::vector<std::int32_t> &tags, const Names &names, const std::vector<std::int32_t> &taken,
                  const Names &known, std::int32_t free) {
    Tags changed;
    for (const std::int32_t tag : tags) {
        const std::optional<std::string> name = nameIn(names, tag);
        const bool used = std::binary_search(taken.begin(), taken.end(), tag);
        if (const std::optional<std::int32_t> same = tagNamed(known, name)) {
            changed[tag] = *same;
        } else if (used && name != nameIn(known, tag)) {
            changed[tag] = free;
            free += free < std::numeric_limits<std::int32_t>::max() ? 1 : 0;
        }
    }
    std::erase_if(changed, [](const auto &each) { return each.first == each.second; });
    return changed;
}

std::int32_t newTag(const Tags &tags, std::int32_t tag) {
    const auto found = tags.find(tag);
    return found == tags.end() ? tag : found->second;
}

template <class Value>
std::map<std::int32_t, Value> retagged(const std::map<std::int32_t, Value> &values, const Tags &tags) {
    std::map<std::int32_t, Value> result;
    for (const auto &[tag, value] : values) {
        result.emplace(newTag(tags, tag), value);
    }
    return result;
}

void retagBoundaries(Document &document, const Tags &tags) {
    for (std::shared_ptr<const Shape> &shape : document.shapes) {
        auto changed = std::make_shared<Shape>(*shape);
        changed->tag = newTag(tags, shape->tag);
        for (std::int32_t &tag : changed->segmentTags) {
            tag = newTag(tags, tag);
        }
        shape = std::move(changed);
    }
    document.boundaryNames = retagged(document.boundaryNames, tags);
    document.spacing.partSizes = retagged(document.spacing.partSizes, tags);
    document.elementCounts = retagged(document.elementCounts, tags);
    for (LayerSpec &layer : document.layers) {
        layer.tag = newTag(tags, layer.tag);
    }
    for (PeriodicSpec &spec : document.periodic) {
        spec = {newTag(tags, spec.from), newTag(tags, spec.to)};
    }
    for (std::int32_t &tag : document.cracks) {
        tag = newTag(tags, tag);
    }
    for (std::int32_t &tag : document.openBoundaries) {
        tag = newTag(tags, tag);
    }
    for (StripSpec &spec : document.strips) {
        spec.tag = newTag(tags, spec.tag);
    }
    std::map<NumberAddress, std::string> formulas;
    for (const auto &[given, text] : document.formulas) {
        NumberAddress address = given;
        if (address.owner.kind == NumberOwner::Kind::Part) {
            address.owner = NumberOwner::ofPart(newTag(tags, static_cast<std::int32_t>(address.owner.id)));
        }
        formulas.emplace(address, text);
    }
    document.formulas = std::move(formulas);
}

void retagRegions(Document &document, const Tags &tags) {
    for (MarkedRegion &marker : document.regionMarkers) {
        marker.tag = newTag(tags, marker.tag);
    }
    for (MappedSpec &spec : document.mapped) {
        spec.region = newTag(tags, spec.region);
    }
    for (StripSpec &spec : document.strips) {
        spec.region = newTag(tags, spec.region);
    }
    for (RegionElements &own : document.regionElements) {
        own.region = newTag(tags, own.region);
    }
    document.regionNames = retagged(document.regionNames, tags);
}

/// Returns the tags of the markers, ascending.
std::vector<std::int32_t> markedTags(const Document &document) {
    std::vector<std::int32_t> tags;
    for (const MarkedRegion &marker : document.regionMarkers) {
        tags.push_back(marker.tag);
    }
    for (const StripSpec &spec : document.strips) {
        if (spec.region > 0) {
            tags.push_back(spec.region);
        }
    }
    std::sort(tags.begin(), tags.end());
    tags.erase(std::unique(tags.begin(), tags.end()), tags.end());
    return tags;
}

} // namespace

Document withDistinctTags(const Document &other, const Document &document) {
    Document result = other;
    const Tags boundaries =
        distinctTags(boundaryTags(other), other.boundaryNames, boundaryTags(document), document.boundaryNames,
                     std::max(freeBoundaryTag(other), freeBoundaryTag(document)));
    if (!boundaries.empty()) {
        retagBoundaries(result, boundaries);
    }
    const std::vector<std::int32_t> regions =
        document.shapes.empty() && document.regionMarkers.empty() ? std::vector<std::int32_t>() : regionTags(document);
    const Tags marked = distinctTags(markedTags(other), other.regionNames, regions, document.regionNames,
                                     std::max(freeRegionTag(other), freeRegionTag(document)));
    if (!marked.empty()) {
        retagRegions(result, marked);
    }
    return result;
}

} // namespace forefront
