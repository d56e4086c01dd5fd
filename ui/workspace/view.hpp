#pragma once

#include "ui/canvas/camera.hpp"
#include "ui/style/colour_map.hpp"

#include <optional>

namespace forefront {

/// The part of the plane in view, and what is highlighted in it.
struct View {
    Camera camera;
    PixelRect room;              ///< part of the canvas free of plates and legends; fitted drawings go there
    std::optional<Box2> fitted;  ///< kept fully visible when the canvas is resized, until the user pans or zooms
    std::optional<Vec2> pointer; ///< place under the pointer while it is over the canvas
    bool panels = true;          ///< Tab hides them
    bool fitPending = true;      ///< fit the drawing as soon as the size of the canvas is known
    std::optional<Vec2> flag;    ///< target of the last goTo(), marked by a ring that fades
    double flagTime = 0.0;
    std::optional<int> isolatedBin;          ///< bin of the histogram of α whose elements are shown alone
    std::optional<ColourRange> qualityRange; ///< of the colours of α; not set: it fits the mesh

    /// Fits a part of the plane into the view, and keeps it fitted when the canvas is resized.
    void fit(const Box2 &box);
    void pan(Pixel pixels);
    void zoomAt(Pixel pixel, double factor);
    /// Adapts the view to a new size of the canvas or of its free room: a fitted box is fitted again, otherwise the
    /// centre stays where it is. Returns false if nothing changed.
    bool resize(const PixelRect &viewport, const PixelRect &roomInIt);
    /// Centres the view on a place, zoomed in enough to see its surroundings, and marks it.
    void goTo(Vec2 place, double now);
};

} // namespace forefront
