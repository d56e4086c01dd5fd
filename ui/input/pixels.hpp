#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace forefront {

/// A position or displacement in framebuffer pixels, y down. Places in the plane are core's Vec2, so that the two are
/// never mixed up.
using Pixel = glm::dvec2;

/// Size in framebuffer pixels.
struct PixelSize {
    int width = 0, height = 0;
    friend bool operator==(PixelSize, PixelSize) = default;
};

/// Rectangle in framebuffer pixels, y down.
struct PixelRect {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;

    bool contains(Pixel p) const { return p.x >= x && p.x < x + width && p.y >= y && p.y < y + height; }
    bool overlaps(const PixelRect &o) const {
        return x < o.x + o.width && o.x < x + width && y < o.y + o.height && o.y < y + height;
    }
    Pixel centre() const { return {x + 0.5 * width, y + 0.5 * height}; }
    friend bool operator==(const PixelRect &, const PixelRect &) = default;
};

} // namespace forefront
