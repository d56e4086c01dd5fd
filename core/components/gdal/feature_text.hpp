#pragma once

#include <ogr_api.h>
#include <string>
#include <string_view>

namespace forefront::gdal {

/// Returns a text as a string of JSON; bytes that are not UTF-8 become question marks.
std::string jsonString(std::string_view text);

/// Appends a geometry as GeoJSON, its numbers such that they read back to the same bits. Curves must have become lines.
/// Returns false if it has a coordinate that is not finite, or is of a kind that GeoJSON does not have.
bool appendGeometry(OGRGeometryH geometry, std::string &text);

/// Appends the attributes of a feature as an object: numbers, and everything else as text; those that are not set are
/// left out.
void appendProperties(OGRFeatureH feature, std::string &text);

} // namespace forefront::gdal
