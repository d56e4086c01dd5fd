#pragma once

#include "core/base/vec2.hpp"
#include "ui/platform/pixels.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

/// Maps the plane (y up, double precision) to framebuffer pixels (y down).
struct Camera {
    Vec2 centre;            ///< place in the middle of the viewport
    double zoom = 50.0;     ///< pixels per domain unit, > 0
    PixelRect viewport;     ///< the canvas in the framebuffer
    double minZoom = 1e-12; ///< limit of zoom, set from the size of the drawing
    double maxZoom = 1e12;

    Vec2 toPixel(Vec2 p) const {
        const Vec2 middle = viewport.centre();
        return {middle.x + (p.x - centre.x) * zoom, middle.y - (p.y - centre.y) * zoom};
    }
    Vec2 toPlane(Vec2 pixel) const {
        const Vec2 middle = viewport.centre();
        return {centre.x + (pixel.x - middle.x) / zoom, centre.y - (pixel.y - middle.y) / zoom};
    }
    /// Returns the part of the plane in view.
    Box2 visible() const {
        const Vec2 half{0.5 * viewport.width / zoom, 0.5 * viewport.height / zoom};
        return {centre - half, centre + half};
    }
    /// Converts a length in pixels to domain units.
    double length(double pixels) const { return pixels / zoom; }

    void pan(Vec2 pixels) { centre = centre - Vec2{pixels.x / zoom, -pixels.y / zoom}; }
    /// Zooms by `factor` and keeps the place under `pixel` fixed.
    void zoomAt(Vec2 pixel, double factor) {
        const Vec2 fixed = toPlane(pixel);
        zoom = std::clamp(zoom * factor, minZoom, maxZoom);
        const Vec2 moved = toPlane(pixel);
        centre += fixed - moved;
    }
    /// Fits `box` into the middle of `room`, a part of the viewport; `margin` is a fraction of the room.
    void fit(const Box2 &box, const PixelRect &room, double margin = 0.05) {
        if (box.empty() || room.width <= 0.0 || room.height <= 0.0) {
            return;
        }
        const Vec2 size = box.size();
        const double extent =
            std::max({size.x, size.y, 1e-9 * std::max({1.0, std::abs(box.max.x), std::abs(box.max.y)})});
        minZoom = 1e-4 * std::min(viewport.width, viewport.height) / extent;
        maxZoom = 1e7 * std::max(viewport.width, viewport.height) / extent;
        const double usable = 1.0 - 2.0 * margin;
        zoom = usable *
               std::min(room.width / std::max(size.x, 1e-3 * extent), room.height / std::max(size.y, 1e-3 * extent));
        const Vec2 aside = room.centre() - viewport.centre();
        centre = box.centre() + Vec2{-aside.x / zoom, aside.y / zoom};
    }

    friend bool operator==(const Camera &, const Camera &) = default;
};

} // namespace forefront
