#include "core/drawing/constraints/settled_shape.hpp"

#include "core/drawing/joints/joint_index.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/polygon.hpp"

#include <vector>

namespace forefront {

bool isTurnedOver(const Shape &before, const Shape &after) {
    const bool closed = sideCount(before) == handleCount(before) && handleCount(before) > 2;
    if (!closed || handleCount(before) != handleCount(after) || (isPath(before) && !before.path().curves.empty())) {
        return false;
    }
    return signedArea(handlesOf(before)) * signedArea(handlesOf(after)) < 0.0;
}

std::optional<std::size_t> vanishedSegment(const Shape &before, const Shape &after) {
    constexpr double kVanished = 1e-6; // of the length before
    if (handleCount(before) != handleCount(after)) {
        return std::nullopt;
    }
    const std::vector<Vec2> from = handlesOf(before), to = handlesOf(after);
    for (std::size_t k = 0; k < sideCount(before); ++k) {
        const std::size_t end = (k + 1) % from.size();
        const double length = distance(from[k], from[end]);
        if (length > 0.0 && distance(to[k], to[end]) <= kVanished * length) {
            return k;
        }
    }
    return std::nullopt;
}

} // namespace forefront
