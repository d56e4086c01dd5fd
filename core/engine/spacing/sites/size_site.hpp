#pragma once

#include "core/engine/base/no_branch.hpp"
#include "core/engine/base/vec2.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace forefront {

/// Maximum number of sites that are evaluated exactly; more would take longer than meshing and are simplified.
inline constexpr std::size_t kManySites = 4096;

/// A point or segment that prescribes an element size: `size` within `radius` of the segment from `a` to a + `ab` (a
/// point if ab = 0), growing by `growth` per unit of distance beyond. The common form of size sources, boundary
/// lengths, features and places from which the gradation limit spreads. One cache line.
struct SizeSite {
    Vec2 a;
    Vec2 ab;
    double inverse = 0.0; ///< 1 / |ab|², 0 for a point
    double radius = 0.0;
    double size = 1.0;
    double growth = 0.0;

    static SizeSite point(Vec2 at, double size, double growth, double radius = 0.0) {
        return {at, {}, 0.0, radius, size, growth};
    }
    static SizeSite segment(Vec2 a, Vec2 b, double size, double growth, double radius = 0.0) {
        const Vec2 ab = b - a;
        const double square = lengthSquared(ab);
        const double inverse = square > 0.0 ? 1.0 / square : 0.0;
        return {a, std::isfinite(inverse) ? ab : Vec2{}, std::isfinite(inverse) ? inverse : 0.0, radius, size, growth};
    }

    Vec2 nearest(Vec2 p) const { return a + std::clamp(dot(p - a, ab) * inverse, 0.0, 1.0) * ab; }
    double distanceTo(Vec2 p) const {
        const double x = p.x - a.x;
        const double y = p.y - a.y;
        const double t = clampedToUnit((x * ab.x + y * ab.y) * inverse);
        const double dx = x - t * ab.x;
        const double dy = y - t * ab.y;
        return notNegative(std::sqrt(dx * dx + dy * dy) - radius);
    }
    double at(Vec2 p) const { return size + growth * distanceTo(p); }
};

/// Returns the site with its size raised to `minimum` and its growth limited to `gradation`. This is the exact limit of
/// max(site, minimum), since the distance to a convex shape less a constant is the distance to its neighbourhood.
inline SizeSite limited(SizeSite site, double minimum, double gradation) {
    if (site.size < minimum) {
        if (site.growth > 0.0) {
            site.radius += (minimum - site.size) / site.growth;
        }
        site.size = minimum;
    }
    site.growth = std::min(site.growth, gradation);
    return site;
}

} // namespace forefront
