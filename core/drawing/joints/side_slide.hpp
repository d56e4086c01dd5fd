#pragma once

#include "core/drawing/document/document.hpp"

#include <cstddef>

namespace forefront {

/// Returns where a node that lies on a straight side of a shape comes to lie when it is pulled to a place: the nearest
/// place on that side or, where the pull leads round a corner, on the straight sides beyond it. At the ends of an open
/// path and before curves it stops.
Vec2 slideAlongSides(const Shape &shape, std::size_t side, Vec2 to);

} // namespace forefront
