#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/shapes/plane_map.hpp"

#include <optional>

namespace forefront {

/// Returns true if a map stretches along the axes without turning or mirroring, by different factors.
bool stretchesAlongAxes(const PlaneMap &map);

/// Stretches a path of lines and arcs of circles so that its arcs keep their radii, as in a sketch: each is moved as a
/// whole, with the sides of the path's box that it touches, and the lines between them take all of the stretch. The box
/// around the path is stretched exactly. None if the path has no arcs of circles or other curves, if an arc does not
/// tell how far it moves, or if arcs that meet would come apart. `map`: see stretchesAlongAxes().
std::optional<Shape> stretchedWithArcs(const Shape &path, const PlaneMap &map);

/// Returns true if a document still has all constraints of another one, and they fit their parts.
bool keepsConstraints(const Document &before, const Document &after);

} // namespace forefront
