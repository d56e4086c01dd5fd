#pragma once

#include "core/drawing/shapes/plane_map.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>

namespace forefront {

/// Returns the slot around the line from `a` to `b` at a distance; a circle if both are one point.
Shape slotAround(Vec2 a, Vec2 b, double radius);

/// Returns true for a slot, and for a path with the form of one: two parallel sides joined by half circles.
bool isSlot(const Shape &shape);

/// Returns true if a slot has a finite width above 0, and centres far enough apart for a direction.
bool isSoundSlot(const Shape &slot);

/// Returns the slot with the form of a path, as slots of older projects are; the path must have that form. Sizes at its
/// nodes are left out.
Shape slotLike(const Shape &path);

/// Converts a path with the form of a slot to a slot, which is edited by its width and length. Error: not-possible for
/// another shape, and for one with element sizes at nodes.
Result<Document> convertToSlot(const Document &document, std::uint32_t shape);

/// Returns the outline of a sound slot.
Outline slotOutline(const Shape &slot);

/// Returns the middle of the left side of a slot, which is the handle for its width.
Vec2 slotSide(const Shape &slot);

/// Moves a centre, or the side at the same distance on both sides.
void placeSlotHandle(Shape &slot, std::uint32_t handle, Vec2 to);

/// Moves the second centre to a distance from the first one, in the same direction.
void setSlotLength(Shape &slot, double length);

/// Maps a slot by a similarity.
void mapSlot(Shape &slot, const PlaneMap &map);

} // namespace forefront
