#pragma once

#include "core/engine/base/vec2.hpp"

#include <string_view>

namespace forefront {

/// Returns true if a coordinate reference system has longitudes and latitudes in degrees. `name` is the one in an old
/// GeoJSON file, such as "urn:ogc:def:crs:OGC:1.3:CRS84" or "EPSG:4326".
bool isGeographic(std::string_view name);
/// Returns the code in a name of EPSG: "EPSG:3067" of "urn:ogc:def:crs:EPSG::3067"; empty for other names.
std::string systemCode(std::string_view name);

/// Returns true if all coordinates of a map in a box can be longitudes, in [-180, 360], and latitudes, in [-90, 90].
bool maybeDegrees(const Box2 &box);

/// Returns the factor by which lengths from west to east are too long, relative to those from south to north, in the
/// middle of a map whose longitudes and latitudes are taken for coordinates in the plane.
double degreeDistortion(const Box2 &box);

} // namespace forefront
