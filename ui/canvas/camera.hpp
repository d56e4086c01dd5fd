#pragma once

#include "core/engine/base/vec2.hpp"
#include "ui/input/pixels.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

/// Maps the plane (y up, double precision) to framebuffer pixels (y down). Not a matrix: the centre is subtracted
/// before the scale is applied, so that a drawing far from the origin keeps all its digits.
struct Camera {
    Vec2 centre;            ///< place in the middle of the viewport
    double zoom = 50.0;     ///< pixels per domain unit, > 0
    PixelRect viewport;     ///< the canvas in the framebuffer
    double minZoom = 1e-12; ///< limit of zoom, set from the size of the drawing
    double maxZoom = 1e12;

    Pixel toPixel(Vec2 place) const { return viewport.centre() + pixelsOf(place - centre); }
    Vec2 toPlane(Pixel pixel) const { return centre + displacementOf(pixel - viewport.centre()); }
    /// Converts a displacement in the plane to pixels.
    Pixel pixelsOf(Vec2 displacement) const { return glm::dvec2(displacement.x, displacement.y) * scale(); }
    /// Converts a displacement in pixels to the plane.
    Vec2 displacementOf(Pixel pixels) const {
        const glm::dvec2 d = pixels / scale();
        return {d.x, d.y};
    }
    /// Returns the part of the plane in view.
    Box2 visible() const {
        const Vec2 half{0.5 * viewport.width / zoom, 0.5 * viewport.height / zoom};
        return {centre - half, centre + half};
    }
    /// Converts a length in pixels to domain units.
    double length(double pixels) const { return pixels / zoom; }

    void pan(Pixel pixels) { centre = centre - displacementOf(pixels); }
    /// Zooms by `factor` and keeps the place under `pixel` fixed.
    void zoomAt(Pixel pixel, double factor) {
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
        centre = box.centre() - displacementOf(room.centre() - viewport.centre());
    }

    friend bool operator==(const Camera &, const Camera &) = default;

  private:
    glm::dvec2 scale() const { return {zoom, -zoom}; }
};

} // namespace forefront
