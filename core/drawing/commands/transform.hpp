#pragma once

#include "core/drawing/shapes/plane_map.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>
#include <span>

namespace forefront {

// Commands that map, align, distribute and repeat the selection. Errors: bad-number (not finite, or a map that makes
// areas vanish), no-such-node, not-possible (too few items, or nothing or too much to copy), bad-shape.

/// Maps a shape. It keeps its kind where its image is of that kind: a circle becomes an ellipse if it is stretched, a
/// rectangle that is turned becomes a polygon.
void mapShape(Shape &shape, const PlaneMap &map);

/// Maps everything selected: whole shapes, single handles, both ends of segments, sources with their radii, markers.
/// Where a path is stretched along the axes and would lose constraints, its arcs of circles keep their radii if all
/// constraints then hold: see stretchedWithArcs().
Result<Document> transformSelection(const Document &document, const Selection &selection, const PlaneMap &map);

/// Adds a copy of the selected shapes, sources and region markers under each map, in order. `copies`, if not null,
/// becomes the selection of all copies.
Result<Document> copySelection(const Document &document, const Selection &selection, std::span<const PlaneMap> maps,
                               Selection *copies = nullptr);

/// The side or middle of the items' boxes that an alignment lines up.
enum class Alignment : std::uint8_t { Left, CentreX, Right, Bottom, CentreY, Top };

/// Aligns the selected shapes, each as a whole, or the selected nodes if no shape is selected, to the box around all of
/// them.
Result<Document> alignSelection(const Document &document, const Selection &selection, Alignment alignment);
/// Moves the selected shapes or nodes between the first and the last along x or y, so that the gaps are equal.
Result<Document> distributeSelection(const Document &document, const Selection &selection, bool alongX);
/// Returns the number of items that alignSelection() moves.
std::size_t alignableItems(const Selection &selection);

/// Repeats the selection in a row: `count` items in all, >= 2, each moved by `step` from the previous one. Errors:
/// those of copySelection(); bad-number.
Result<Document> linearArray(const Document &document, const Selection &selection, double count, Vec2 step,
                             Selection *copies = nullptr);
/// Repeats the selection around a centre: `count` items in all, over an angle in degrees. 360 fills the circle evenly;
/// a smaller angle has an item at both ends. `turns` rotates the copies, too. Errors: those of copySelection();
/// bad-number.
Result<Document> polarArray(const Document &document, const Selection &selection, double count, Vec2 centre,
                            double degrees, bool turns, Selection *copies = nullptr);

} // namespace forefront
