#pragma once

#include "core/base/vec2.hpp"

#include <optional>
#include <string_view>

namespace forefront {

/// An affine map, x' = a·x + c·y + e, y' = b·x + d·y + f, in the notation of SVG.
struct AffineMap {
    double a = 1.0, b = 0.0, c = 0.0, d = 1.0, e = 0.0, f = 0.0;

    Vec2 operator()(Vec2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
    /// Returns the map that applies `inner` first, then this.
    AffineMap operator*(const AffineMap &inner) const;
    /// Returns the maximum factor by which it stretches a length.
    double stretch() const;
};

/// Parses the attribute `transform`: a list of matrix, translate, scale, rotate, skewX, skewY; std::nullopt if
/// malformed.
std::optional<AffineMap> parseTransform(std::string_view text);

} // namespace forefront
