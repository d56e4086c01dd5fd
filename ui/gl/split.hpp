#pragma once

#include "core/engine/base/vec2.hpp"

#include <glm/vec2.hpp>

namespace forefront {

/// A position split into the sum of two single-precision positions. Subtracting a camera centre split the same way
/// keeps about 48 bits, so that a drawing at an offset of 1e5 is as sharp as one at the origin.
struct SplitPoint {
    glm::vec2 high{}, low{};

    SplitPoint() = default;
    explicit SplitPoint(Vec2 p)
        : high(p.x, p.y), low(p.x - static_cast<double>(high.x), p.y - static_cast<double>(high.y)) {}
};

} // namespace forefront
