#include "core/drawing/names/region_commands.hpp"

#include "core/engine/spacing/spec/spec_check.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace forefront {
namespace {

Diagnostics badTag(std::int32_t tag) {
    return error("bad-tag", "invalid tag " + std::to_string(tag) + "; expected 1 or more");
}

Diagnostics noSuchMarker() {
    return error("no-such-marker", "region marker not found");
}

void setName(std::map<std::int32_t, std::string> &names, std::int32_t tag, std::string name) {
    if (name.empty()) {
        names.erase(tag);
    } else {
        names[tag] = std::move(name);
    }
}

} // namespace

Result<Document> addRegionMarker(const Document &document, MarkedRegion marker) {
    if (marker.tag < 1) {
        return badTag(marker.tag);
    }
    if (!isFinite(marker.at)) {
        return error("bad-number", "invalid coordinate; expected a finite number");
    }
    if (!(marker.maxArea >= 0.0) || !std::isfinite(marker.maxArea)) {
        return error("bad-number", "invalid maximum area; expected a number of at least 0");
    }
    Diagnostics faults;
    const RegionSize sizes = marker.sizes();
    checkRegions({&sizes, 1}, faults);
    if (!faults.empty()) {
        return faults;
    }
    Document next = document;
    next.regionMarkers.push_back(marker);
    return next;
}

Result<Document> moveRegionMarker(const Document &document, std::size_t index, Vec2 to) {
    if (index >= document.regionMarkers.size()) {
        return noSuchMarker();
    }
    if (!isFinite(to)) {
        return error("bad-number", "invalid coordinate; expected a finite number");
    }
    Document next = document;
    next.regionMarkers[index].at = to;
    return next;
}

Result<Document> setRegionTag(const Document &document, std::size_t index, std::int32_t tag) {
    if (index >= document.regionMarkers.size()) {
        return noSuchMarker();
    }
    if (tag < 1) {
        return badTag(tag);
    }
    Document next = document;
    next.regionMarkers[index].tag = tag;
    return next;
}

Result<Document> setRegionArea(const Document &document, std::size_t index, double maxArea) {
    if (index >= document.regionMarkers.size()) {
        return noSuchMarker();
    }
    if (!(maxArea >= 0.0) || !std::isfinite(maxArea)) {
        return error("bad-number", "invalid maximum area; expected a number of at least 0, where 0 means no limit");
    }
    Document next = document;
    next.regionMarkers[index].maxArea = maxArea;
    return next;
}

Result<Document> setRegionSize(const Document &document, std::size_t index, std::optional<PartSize> size) {
    if (index >= document.regionMarkers.size()) {
        return noSuchMarker();
    }
    const std::string owner = "region '" + regionName(document.regionNames, document.regionMarkers[index].tag) + "'";
    if (auto fault = partSizeFault(size.value_or(PartSize()), owner, "bad-source")) {
        return Diagnostics{*std::move(fault)};
    }
    Document next = document;
    next.regionMarkers[index].size = size ? size->size : 0.0;
    next.regionMarkers[index].growth = size.value_or(PartSize()).growth;
    return next;
}

Result<Document> removeRegionMarker(const Document &document, std::size_t index) {
    if (index >= document.regionMarkers.size()) {
        return noSuchMarker();
    }
    Document next = document;
    next.regionMarkers.erase(next.regionMarkers.begin() + static_cast<std::ptrdiff_t>(index));
    return next;
}

Result<Document> setBoundaryName(const Document &document, std::int32_t tag, std::string name) {
    if (tag < 1) {
        return badTag(tag);
    }
    Document next = document;
    setName(next.boundaryNames, tag, std::move(name));
    return next;
}

Result<Document> setRegionName(const Document &document, std::int32_t tag, std::string name) {
    if (tag < 1) {
        return badTag(tag);
    }
    Document next = document;
    setName(next.regionNames, tag, std::move(name));
    return next;
}

Result<Document> setCircleTolerance(const Document &document, double tolerance) {
    if (!(tolerance > 0.0 && tolerance <= 0.5)) {
        return error("bad-tolerance", "invalid circle tolerance; expected a number above 0 and at most 0.5");
    }
    Document next = document;
    next.circleTolerance = tolerance;
    return next;
}

std::vector<std::int32_t> boundaryTags(const Document &document) {
    std::set<std::int32_t> tags;
    for (const auto &shape : document.shapes) {
        if (shape->construction) {
            continue;
        }
        if (shape->segmentTags.empty()) {
            tags.insert(shape->tag);
        }
        tags.insert(shape->segmentTags.begin(), shape->segmentTags.end());
    }
    for (const auto &[tag, name] : document.boundaryNames) {
        tags.insert(tag);
    }
    return {tags.begin(), tags.end()};
}

std::vector<std::int32_t> regionTags(const Document &document) {
    std::set<std::int32_t> tags{1};
    for (const MarkedRegion &marker : document.regionMarkers) {
        tags.insert(marker.tag);
    }
    for (const auto &[tag, name] : document.regionNames) {
        tags.insert(tag);
    }
    return {tags.begin(), tags.end()};
}

std::int32_t freeRegionTag(const Document &document) {
    std::int32_t last = regionTags(document).back();
    for (const MappedSpec &spec : document.mapped) { // of a deleted region
        last = std::max(last, spec.region);
    }
    for (const StripSpec &spec : document.strips) {
        last = std::max(last, spec.region);
    }
    for (const RegionElements &own : document.regionElements) {
        last = std::max(last, own.region);
    }
    return last < std::numeric_limits<std::int32_t>::max() ? last + 1 : last;
}

} // namespace forefront
