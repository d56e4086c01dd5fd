#pragma once

#include "core/engine/geometry/curve.hpp"
#include "ui/canvas/camera.hpp"
#include "ui/canvas/label_space.hpp"
#include "ui/style/colour.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

struct ImDrawList;
struct ImFont;

namespace forefront {

struct Outline;

/// Draws primitives over the canvas that change with every frame, such as tool overlays, labels and candidates.
/// Positions are in domain units, widths and radii in design pixels (scaled for HiDPI here). It can draw thousands of
/// primitives; millions belong in GPU batches.
class CanvasPainter {
  public:
    CanvasPainter(ImDrawList &list, const Camera &camera, double scale) : list_(list), camera_(camera), scale_(scale) {}

    /// What is drawn at a level lies above what is drawn at those before it, whatever comes first.
    enum class Level : std::uint8_t { Layers, Tool, Labels };
    /// Begins to draw at levels, with that of the layers; until endLevels(), labels lie above all lines.
    void beginLevels();
    void setLevel(Level level);
    void endLevels();

    void line(Vec2 a, Vec2 b, Colour colour, double width = 1.5);
    void dashed(Vec2 a, Vec2 b, Colour colour, double width = 1.5, double dash = 6.0);
    /// Draws a line with a filled arrowhead at b.
    void arrow(Vec2 a, Vec2 b, Colour colour, double width = 2.0, double head = 9.0);
    void polyline(std::span<const Vec2> points, bool closed, Colour colour, double width = 1.5);
    /// Draws a curve as a polyline that looks smooth at the current zoom.
    void curve(const Curve &curve, Colour colour, double width = 1.5);
    /// Does the same for all segments of an outline.
    void outline(const Outline &outline, Colour colour, double width = 1.5);
    void triangle(Vec2 a, Vec2 b, Vec2 c, Colour fill);
    void quadrilateral(const std::array<Vec2, 4> &corners, Colour fill);
    void rectangle(const Box2 &box, Colour colour, double width = 1.0);
    void fillRectangle(const Box2 &box, Colour fill);
    /// Draws a filled dot; the radius is in design pixels, as for ring() and cross().
    void dot(Vec2 centre, double radius, Colour fill);
    void ring(Vec2 centre, double radius, Colour colour, double width = 1.5);
    /// Draws a square node handle; `radius` is half its side in design pixels.
    void handle(Vec2 centre, double radius, Colour fill, Colour border);
    void cross(Vec2 centre, double radius, Colour colour, double width = 1.5);
    /// Draws a tick in a circle of that radius.
    void tick(Vec2 centre, double radius, Colour colour, double width = 1.5);
    /// Draws a circle; the radius is in domain units, as for disc() and dashedCircle().
    void circle(Vec2 centre, double radius, Colour colour, double width = 1.5);
    void disc(Vec2 centre, double radius, Colour fill);
    void dashedCircle(Vec2 centre, double radius, Colour colour, double width = 1.5);
    /// Draws text on a rounded plate, `offset` design pixels from the place. Where that would cover another label or a
    /// reserved area, or the edge of the room, it lies on another side of the place. Returns its rectangle in pixels.
    PixelRect label(Vec2 at, Pixel offset, std::string_view text, Colour colour, Colour plate, ImFont *font = nullptr);
    /// Draws a label at an offset, whatever it covers.
    void fixedLabel(Vec2 at, Pixel offset, std::string_view text, Colour colour, Colour plate, ImFont *font = nullptr);
    /// Returns the offset of a label with a rectangle, in design pixels: the inverse of labelRect().
    Pixel offsetOf(Vec2 at, const PixelRect &label) const;
    /// Returns the rectangle of a label at an offset, in pixels.
    PixelRect labelRect(Vec2 at, Pixel offset, std::string_view text, ImFont *font) const;
    /// Draws a label where it covers no other label, no reserved area or line and no edge: at `offset`, otherwise on
    /// the other side of the place, above or below it. Returns false, and draws nothing, if all of these are taken.
    bool freeLabel(Vec2 at, Pixel offset, std::string_view text, Colour colour, Colour plate, ImFont *font = nullptr);
    /// Draws a label at the first of some offsets where it covers nothing of that.
    bool freeLabel(Vec2 at, std::span<const Pixel> offsets, std::string_view text, Colour colour, Colour plate,
                   ImFont *font = nullptr);
    /// Returns the first of some offsets at which freeLabel() would draw a label; none if there is no room.
    std::optional<Pixel> freeOffset(Vec2 at, std::span<const Pixel> offsets, std::string_view text, ImFont *font) const;
    /// Returns the size of a label with its plate, in design pixels.
    Pixel labelSize(std::string_view text, ImFont *font) const;
    /// Draws an edge around a rectangle of pixels, such as that of a label.
    void frame(const PixelRect &rect, Colour colour);
    /// Draws a thin line from a place to the nearest point of the label drawn last.
    void leader(Vec2 from, Colour colour);
    /// Keeps labels inside a rectangle of pixels, such as the canvas.
    void keepInside(const PixelRect &room);
    /// Keeps labels out of a rectangle of pixels.
    void reserve(const PixelRect &rect) { space_.take(rect); }
    /// Keeps free labels off the line of an outline.
    void reserve(const Outline &outline);
    /// Keeps labels off a place, such as a handle; the radius is in design pixels.
    void reserve(Vec2 place, double radius);
    /// Keeps labels off the line from a to b.
    void reserveLine(Vec2 a, Vec2 b) { space_.takeLine(camera_.toPixel(a), camera_.toPixel(b)); }
    /// Draws text without a plate, centred on the place.
    void text(Vec2 at, std::string_view text, Colour colour, ImFont *font = nullptr);

    /// A label that was drawn.
    struct Placed {
        PixelRect rect;
        std::string text;
        bool free = false;  ///< drawn by freeLabel()
        std::string name{}; ///< of its widget; empty: it cannot be clicked
    };
    /// Names the widget of the label drawn last, so that it can be clicked.
    void nameLabel(std::string name) { placed_.back().name = std::move(name); }
    const std::vector<Placed> &labels() const { return placed_; }

    const Camera &camera() const { return camera_; }
    double scale() const { return scale_; }
    ImDrawList &list() { return list_; }

  private:
    /// Adds the points after the first of a polyline along a curve, fine enough in the view to look smooth.
    void addAlong(const Curve &curve, double width, std::vector<Vec2> &points) const;
    /// Calls `draw` at the level of labels, if there are levels.
    template <class Draw>
    void aboveLines(const Draw &draw);
    void drawLabel(const PixelRect &rect, std::string_view text, Colour colour, Colour plate, ImFont *font, bool free);

    ImDrawList &list_;
    const Camera &camera_;
    double scale_;
    std::optional<Level> level_; ///< empty: what is drawn later lies above
    LabelSpace space_;
    std::vector<Placed> placed_;
};

} // namespace forefront
