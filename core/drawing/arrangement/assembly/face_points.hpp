#pragma once

#include "core/engine/base/vec2.hpp"
#include "core/engine/geometry/plane_sweep.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace forefront {

/// An edge around or inside a face.
struct FaceEdge {
    Vec2 a;
    Vec2 b;
    bool twice = false; ///< the face lies on both sides
};

/// Returns a point well inside the face with these edges, away from all of them; std::nullopt if rounding leaves no
/// room.
std::optional<Vec2> pointInFace(std::span<const FaceEdge> edges);

} // namespace forefront
