#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

#include <optional>
#include <string>
#include <vector>

namespace forefront {

// Commands on regions, names and options. Errors: bad-tag, bad-number, bad-source, no-such-marker,
// bad-tolerance.

Result<Document> addRegionMarker(const Document &document, MarkedRegion marker);
Result<Document> moveRegionMarker(const Document &document, std::size_t index, Vec2 to);
Result<Document> setRegionTag(const Document &document, std::size_t index, std::int32_t tag);
/// Sets the maximum area of elements in a region; 0: no limit.
Result<Document> setRegionArea(const Document &document, std::size_t index, double maxArea);
/// Sets the size and growth of elements in a region; nullopt removes them. Error: bad-source.
Result<Document> setRegionSize(const Document &document, std::size_t index, std::optional<PartSize> size);
Result<Document> removeRegionMarker(const Document &document, std::size_t index);

/// Names a boundary tag; an empty name restores the default.
Result<Document> setBoundaryName(const Document &document, std::int32_t tag, std::string name);
Result<Document> setRegionName(const Document &document, std::int32_t tag, std::string name);

/// Sets the tolerance of circles, in (0, 0.5], relative to the radius.
Result<Document> setCircleTolerance(const Document &document, double tolerance);

/// Returns the tags that boundaries and constraints use or that have a name, ascending.
std::vector<std::int32_t> boundaryTags(const Document &document);
/// Returns 1 and the tags that region markers use or that have a name, ascending.
std::vector<std::int32_t> regionTags(const Document &document);
/// Returns the smallest tag above all region tags in use.
std::int32_t freeRegionTag(const Document &document);

} // namespace forefront
