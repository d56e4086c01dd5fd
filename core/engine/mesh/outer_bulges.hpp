#pragma once

#include "core/engine/base/vec2.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// An edge of the outer boundary of a mesh, as the Bézier curve of degree 2 that its middle node makes it.
struct OuterEdge {
    Vec2 start, control, end; ///< control: on the chord where the edge is straight
    bool bulges = false;      ///< it bends away from its element
};

/// Returns the edges that bulge over another edge across the outside of the mesh, ascending: the others, and the chords
/// of all, must not meet other than at common ends. An edge is also found if its curve comes so close to another that
/// the control polygons of their parts, of a thousandth of their lengths, cannot be separated.
std::vector<std::uint32_t> meetingBulges(std::span<const OuterEdge> edges);

} // namespace forefront
