#include "core/drawing/names/part_commands.hpp"

#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// A document in which a part of the boundary has one tag.
struct PartWithTag {
    Document document;
    std::int32_t tag = 1;
};

/// Returns the tag of the first segment of a part; 0: it has none.
std::int32_t firstTag(const Document &document, const BoundaryPart &part) {
    for (const std::uint32_t id : part.shapes) {
        if (const Shape *const shape = findShape(document, id)) {
            return taggedSegments(*shape) > 0 ? segmentTag(*shape, 0) : shape->tag;
        }
    }
    for (const SegmentRef &segment : part.segments) {
        if (const Shape *const shape = findShape(document, segment.shape)) {
            return segmentTag(*shape, segment.segment);
        }
    }
    return 0;
}

template <class Spec>
const Spec *specOf(const std::vector<Spec> &specs, std::int32_t tag) {
    const auto found = std::find_if(specs.begin(), specs.end(), [tag](const Spec &spec) { return spec.tag == tag; });
    return found == specs.end() ? nullptr : &*found;
}

/// Gives one tag what another one has: sizes, numbers of elements, layers, cracks, strips and whether water flows
/// through it. Of periodic parts there are two each, no more.
void copyProperties(Document &document, std::int32_t from, std::int32_t to) {
    const auto copySpec = [&](auto &specs) {
        const auto *const found = specOf(specs, from);
        if (found != nullptr) {
            auto copy = *found;
            copy.tag = to;
            specs.push_back(std::move(copy));
        }
    };
    copySpec(document.layers);
    copySpec(document.strips);
    if (const auto size = document.spacing.partSizes.find(from); size != document.spacing.partSizes.end()) {
        document.spacing.partSizes.emplace(to, PartSize(size->second));
    }
    if (const auto count = document.elementCounts.find(from); count != document.elementCounts.end()) {
        document.elementCounts.emplace(to, PartElements(count->second));
    }
    if (isCrack(document, from)) {
        document.cracks.push_back(to);
    }
    if (std::ranges::count(document.openBoundaries, from) > 0) {
        document.openBoundaries.push_back(to);
    }
}

/// Gives a part a tag of its own, with what its tag has, unless the tag has a name, which means all that has it.
Result<PartWithTag> withTag(const Document &document, const BoundaryPart &part) {
    const std::int32_t before = firstTag(document, part);
    if (before != 0 && document.boundaryNames.contains(before)) {
        return PartWithTag{document, before};
    }
    Result<Document> next = nameBoundaryPart(document, part, {});
    if (!next) {
        return next.faults();
    }
    PartWithTag owned{*std::move(next), 0};
    owned.tag = firstTag(owned.document, part);
    if (owned.tag != before) {
        copyProperties(owned.document, before, owned.tag);
    }
    return owned;
}

/// Sets what a list of a document has for a part; nullopt removes it. `faultOf` checks its numbers.
template <class Spec>
Result<Document> setSpec(const Document &document, const BoundaryPart &part, std::optional<Spec> spec,
                         std::vector<Spec> Document::*list,
                         std::optional<Diagnostic> (*faultOf)(const Spec &, std::string_view)) {
    Result<PartWithTag> owned = withTag(document, part);
    if (!owned) {
        return owned.faults();
    }
    Document next = std::move(owned->document);
    const std::int32_t tag = owned->tag;
    std::vector<Spec> &specs = next.*list;
    const auto found = std::find_if(specs.begin(), specs.end(), [tag](const Spec &own) { return own.tag == tag; });
    if (!spec) {
        if (found != specs.end()) {
            specs.erase(found);
        }
        return next;
    }
    spec->tag = tag;
    if (const auto fault = faultOf(*spec, boundaryName(next.boundaryNames, tag))) {
        return Diagnostics{*fault};
    }
    if (found != specs.end()) {
        *found = *std::move(spec);
    } else {
        specs.push_back(*std::move(spec));
    }
    return next;
}

} // namespace

Result<Document> setLayers(const Document &document, const BoundaryPart &part, std::optional<LayerSpec> spec) {
    return setSpec(document, part, std::move(spec), &Document::layers, layerFault);
}

Result<Document> setStrip(const Document &document, const BoundaryPart &part, std::optional<StripSpec> spec) {
    return setSpec(document, part, std::move(spec), &Document::strips, stripFault);
}

Result<Document> setCrack(const Document &document, const BoundaryPart &part, bool cracks) {
    Result<PartWithTag> owned = withTag(document, part);
    if (!owned) {
        return owned.faults();
    }
    Document next = std::move(owned->document);
    if (!cracks) {
        std::erase(next.cracks, owned->tag);
    } else if (!isCrack(next, owned->tag)) {
        next.cracks.push_back(owned->tag);
    }
    return next;
}

Result<Document> setPeriodic(const Document &document, const BoundaryPart &part, std::optional<std::int32_t> partner) {
    const auto untie = [](Document &next, std::int32_t tag) {
        std::erase_if(next.periodic, [tag](const PeriodicSpec &spec) { return spec.from == tag || spec.to == tag; });
    };
    if (!partner) {
        Document next = document;
        untie(next, firstTag(document, part));
        return next;
    }
    Result<PartWithTag> owned = withTag(document, part);
    if (!owned) {
        return owned.faults();
    }
    if (owned->tag == *partner) {
        return error("not-possible", "a part cannot be periodic with itself", "choose another part");
    }
    Document next = std::move(owned->document);
    untie(next, owned->tag);
    untie(next, *partner);
    next.periodic.push_back({owned->tag, *partner});
    return next;
}

Document setMapped(const Document &document, std::int32_t region, bool mapped) {
    Document next = document;
    if (!mapped) {
        std::erase_if(next.mapped, [region](const MappedSpec &spec) { return spec.region == region; });
    } else if (!isMapped(next, region)) {
        next.mapped.push_back({region, {}});
    }
    return next;
}

Document setMappedCorners(const Document &document, std::int32_t region, std::vector<Vec2> corners) {
    Document next = document;
    const auto found = std::ranges::find(next.mapped, region, &MappedSpec::region);
    if (found != next.mapped.end()) {
        found->corners = std::move(corners);
    }
    return next;
}

Document setElements(const Document &document, std::int32_t region, std::optional<Elements> elements) {
    Document next = document;
    std::erase_if(next.regionElements, [region](const RegionElements &own) { return own.region == region; });
    if (elements) {
        next.regionElements.push_back({region, *elements});
    }
    return next;
}

std::optional<Elements> elementsOf(const Document &document, std::int32_t region) {
    const auto found = std::ranges::find(document.regionElements, region, &RegionElements::region);
    return found == document.regionElements.end() ? std::nullopt : std::optional(found->elements);
}

const LayerSpec *layersOf(const Document &document, std::int32_t tag) {
    return specOf(document.layers, tag);
}

const StripSpec *stripOf(const Document &document, std::int32_t tag) {
    return specOf(document.strips, tag);
}

std::optional<std::int32_t> periodicPartner(const Document &document, std::int32_t tag) {
    for (const PeriodicSpec &spec : document.periodic) {
        if (spec.from == tag || spec.to == tag) {
            return spec.from == tag ? spec.to : spec.from;
        }
    }
    return std::nullopt;
}

bool isCrack(const Document &document, std::int32_t tag) {
    return std::find(document.cracks.begin(), document.cracks.end(), tag) != document.cracks.end();
}

bool isMapped(const Document &document, std::int32_t region) {
    return mappedOf(document, region) != nullptr;
}

const MappedSpec *mappedOf(const Document &document, std::int32_t region) {
    const auto found = std::ranges::find(document.mapped, region, &MappedSpec::region);
    return found == document.mapped.end() ? nullptr : &*found;
}

} // namespace forefront
