#pragma once

#include "core/engine/mesh/limits.hpp"
#include "core/engine/mesh/measures.hpp"
#include "core/engine/session/snapshot.hpp"
#include "core/teaching/lesson/lesson_colours.hpp"
#include "ui/canvas/camera.hpp"
#include "ui/style/measure_colours.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace forefront {

/// A candidate of an explained advance, chosen in its table and highlighted on the canvas.
struct CandidateChoice {
    std::uint64_t run = 0, advance = 0;
    std::size_t candidate = 0; ///< index into AdvanceExplanation::candidates
};

/// The effect of a click with the trace tool.
enum class TraceMode : std::uint8_t {
    Birth, ///< goes to the advance that made the part clicked on
    Place, ///< stops the run when an element covers the point
    Cell   ///< stops the run when the search visits the cell of the background grid
};

/// The values that the histogram shows and the layer "quality" colours by.
struct ColourChoice {
    Measure measure = Measure::ShapeFactor;
    MeshPart fieldPart = MeshPart::Nodes; ///< that has the values of `field`: nodes or elements
    std::string field;                    ///< values of the file shown instead of the measure; empty: none
    LessonColours formula{};              ///< that a page of a lesson shows instead of both; empty: none
    QualityScale scale = QualityScale::Alarm;
    bool fitRange = false;                   ///< the range of the colours fits the mesh; false: the fixed one, if any
    std::optional<ColourRange> measureRange; ///< of the colours of the measure, set by the user

    friend bool operator==(const ColourChoice &, const ColourChoice &) = default;
};

/// A limit of meshes that the user drags in the legend.
struct DraggedLimit {
    MeshLimit limit = MeshLimit::MinAlpha;
    double value = 0.0;
};

/// The part of the plane in view, and what is highlighted in it.
struct View : ColourChoice {
    Camera camera;
    PixelRect room;                ///< part of the canvas free of plates and legends; fitted drawings go there
    PixelRect open;                ///< part of the canvas that a column over it leaves in sight
    std::uint64_t jumps = 0;       ///< of the camera to a target, see Glide
    std::optional<Box2> fitted;    ///< kept fully visible when the canvas is resized, until the user pans or zooms
    std::optional<Vec2> pointer;   ///< place under the pointer while it is over the canvas
    std::optional<Vec2> facePlace; ///< a place in the face that the active tool points at
    bool panels = true;            ///< Tab hides them
    bool following = false;        ///< the camera follows the current advance, see followAdvance()
    bool fitPending = true;        ///< fit the drawing as soon as the size of the canvas is known
    std::optional<Vec2> flag;      ///< target of the last goTo(), marked by a ring that fades
    double flagTime = 0.0;
    std::optional<CandidateChoice> candidate;
    std::array<bool, kMarkKinds> marks{true, false, true, true, true, true}; ///< shown on the timeline
    std::optional<DraggedLimit> draggedLimit;
    TraceMode traceMode = TraceMode::Birth;
    bool runPlot = false;           ///< show the curves of the run above the timeline
    std::optional<int> isolatedBin; ///< bin of the histogram whose parts are shown alone

    /// Fits a part of the plane into the view, and keeps it fitted when the canvas is resized. Like every other camera
    /// move below, it stops following the front.
    void fit(const Box2 &box);
    void pan(Pixel pixels);
    void zoomAt(Pixel pixel, double factor);
    /// Zooms out just enough to show a box, such as that of typed numbers, together with what is in view; does nothing
    /// if the box is in view.
    void reveal(const Box2 &box);
    /// Changes the scale of the plane so that what was in the box `before` now lies in `after`, at the same pixels.
    /// Both have the same proportions.
    void rescale(const Box2 &before, const Box2 &after);
    /// Adapts the view to a new size of the canvas or of its free room: a fitted box is fitted again, otherwise the
    /// centre stays where it is. Returns false if nothing changed.
    bool resize(const PixelRect &viewport, const PixelRect &roomInIt);
    /// Centres the view on a place, zoomed in enough to see its surroundings, and marks it.
    void goTo(Vec2 place, double now);
};

} // namespace forefront
