#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/shapes/plane_map.hpp"

#include <cstdint>
#include <map>
#include <set>

namespace forefront {

/// Adapts the constraints that are wholly within some shapes to a map by which these were moved, turned, mirrored or
/// scaled: lengths scale, and horizontal and vertical lines that were turned stay parallel and perpendicular to each
/// other. Constraints that cannot hold in the image, such as a horizontal distance after a turn, are removed. What
/// also binds other shapes keeps its kind and value, and gets the sides and turns that it has in the image.
void mapConstraints(Document &document, const std::set<std::uint32_t> &shapes, const PlaneMap &map);

/// Copies the constraints that are wholly within some shapes of a document to the copies of these. `copies` maps the
/// ids of the shapes to those of their copies in `to`. Returns the ids of the constraints with those of their copies.
std::map<std::uint32_t, std::uint32_t> copyConstraints(Document &to, const Document &from,
                                                       const std::map<std::uint32_t, std::uint32_t> &copies);

} // namespace forefront
