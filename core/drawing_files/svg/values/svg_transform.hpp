#pragma once

#include "core/engine/base/vec2.hpp"

#include <cmath>
#include <optional>
#include <string_view>

namespace forefront {

/// An affine map, x' = a·x + c·y + e, y' = b·x + d·y + f, in the notation of SVG.
struct AffineMap {
    double a = 1.0, b = 0.0, c = 0.0, d = 1.0, e = 0.0, f = 0.0;

    Vec2 operator()(Vec2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
    /// Returns the map that applies `inner` first, then this.
    AffineMap operator*(const AffineMap &inner) const;
    /// Returns the largest scale factor of the map.
    double stretch() const;
    /// Returns the smallest scale factor of the map.
    double minStretch() const {
        const double maximum = stretch();
        return maximum > 0.0 ? std::fabs(a * d - b * c) / maximum : 0.0;
    }

    /// Returns the inverse map; std::nullopt if the map is singular.
    std::optional<AffineMap> inverse() const;

    /// Returns the map that moves the origin to `to`.
    static AffineMap translation(Vec2 to) { return {1.0, 0.0, 0.0, 1.0, to.x, to.y}; }
};

/// Parses a transform of SVG or CSS: a list of matrix, translate, scale, rotate, skew and one-axis functions such as
/// translateX. Lengths and angles may have units; percentages of lengths refer to `viewport`. Returns std::nullopt if
/// it is malformed.
std::optional<AffineMap> parseTransform(std::string_view text, Vec2 viewport);

/// Parses the property `transform-origin`: one or two lengths or keywords, such as "center" or "50% 10px".
/// Returns std::nullopt if it is malformed.
std::optional<Vec2> parseTransformOrigin(std::string_view text, Vec2 viewport);

} // namespace forefront
