#pragma once

#include "ui/canvas/camera.hpp"
#include "ui/style/colour_map.hpp"

#include <optional>

namespace forefront {

/// What is in view.
struct View {
    Camera camera;
    PixelRect room;              ///< part of the canvas that plates and legends leave free: what is fitted goes there
    std::optional<Box2> fitted;  ///< shown whole whatever the size of the canvas, until the user pans or zooms
    std::optional<Vec2> pointer; ///< place under the pointer while it is over the canvas
    bool panels = true;          ///< Tab hides them
    bool fitPending = true;      ///< fit the drawing as soon as the size of the canvas is known
    std::optional<Vec2> flag;    ///< place gone to, marked by a ring that fades
    double flagTime = 0.0;
    std::optional<int> isolatedBin;          ///< bin of the histogram of α whose elements are shown alone
    std::optional<ColourRange> qualityRange; ///< of the colours of α; not set: it fits the mesh

    /// Shows a part of the plane whole, and goes on doing so while the canvas changes its size.
    void fit(const Box2 &box);
    void pan(Vec2 pixels);
    void zoomAt(Vec2 pixel, double factor);
    /// The canvas has another size, or another room in it: what was fitted fits again; else the place in the middle
    /// stays there. False if nothing changed.
    bool resize(const PixelRect &viewport, const PixelRect &roomInIt);
    /// Brings a place into view, close enough to see its surroundings, and marks it.
    void goTo(Vec2 place, double now);
};

} // namespace forefront
