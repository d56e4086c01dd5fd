#pragma once

#include "core/base/vec2.hpp"

namespace forefront {

/// A double split into the sum of two floats. Subtracting a camera centre split the same way keeps about 48 bits, so
/// that a drawing at an offset of 1e5 is as sharp as one at the origin.
struct SplitFloat {
    float high = 0.0F, low = 0.0F;

    SplitFloat() = default;
    explicit SplitFloat(double value)
        : high(static_cast<float>(value)), low(static_cast<float>(value - static_cast<double>(high))) {}
};

struct SplitPoint {
    SplitFloat x, y;

    SplitPoint() = default;
    explicit SplitPoint(Vec2 p) : x(p.x), y(p.y) {}
};

} // namespace forefront
