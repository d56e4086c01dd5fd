#pragma once

#include "core/base/result.hpp"
#include "core/edit/document.hpp"

#include <string>
#include <vector>

namespace forefront {

/// Commands on regions, names and options. Refused with bad-tag, bad-number, no-such-marker, bad-tolerance.

Result<Document> addRegionMarker(const Document &document, RegionMarker marker);
Result<Document> moveRegionMarker(const Document &document, std::size_t index, Vec2 to);
Result<Document> setRegionTag(const Document &document, std::size_t index, std::int32_t tag);
Result<Document> removeRegionMarker(const Document &document, std::size_t index);

/// Name of a tag; empty: back to the default name.
Result<Document> setBoundaryName(const Document &document, std::int32_t tag, std::string name);
Result<Document> setRegionName(const Document &document, std::int32_t tag, std::string name);

Document setOptions(const Document &document, MeshingOptions options);
/// In (0, 0.5].
Result<Document> setCircleTolerance(const Document &document, double tolerance);

/// Tags in use on boundaries and constraints or named, ascending.
std::vector<std::int32_t> boundaryTags(const Document &document);
/// Tags of region markers or named, and 1; ascending.
std::vector<std::int32_t> regionTags(const Document &document);
/// The least tag above all in use.
std::int32_t freeRegionTag(const Document &document);

} // namespace forefront
