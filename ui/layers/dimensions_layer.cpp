#include "core/drawing/constraints/constraint_figures.hpp"
#include "core/drawing/shapes/dimensions.hpp"
#include "core/drawing/shapes/references.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/layers/layers.hpp"
#include "ui/style/imgui_versions.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Maximum number of dimensions drawn; more would be clutter.
constexpr std::size_t kMaxDimensions = 250;
/// Minimum extent of a dimension with a text, in design pixels.
constexpr double kLeastExtent = 16.0;
constexpr double kLeastLeg = 44.0;   ///< of an angle
constexpr double kAngleArc = 16.0;   ///< radius of the arc that marks an angle
constexpr double kTextGap = 6.0;     ///< between a line and the text beside it; clear of the handles on the line
constexpr double kEdgeMargin = 32.0; ///< at the edge of the canvas
constexpr double kPlateRim = 5.0;    ///< of the plate around a text

std::string textOf(const Dimension &dimension) {
    switch (dimension.kind) {
    case DimensionKind::Radius:
        return "R " + ui::number(dimension.value, 5);
    case DimensionKind::RadiusX:
        return "rx " + ui::number(dimension.value, 5);
    case DimensionKind::RadiusY:
        return "ry " + ui::number(dimension.value, 5);
    case DimensionKind::Angle:
        return ui::number(dimension.value, 4) + "\xc2\xb0";
    default:
        return ui::number(dimension.value, 5);
    }
}

/// Returns the part of the segment from a to b inside a box.
std::optional<std::pair<Vec2, Vec2>> partInside(const Box2 &box, Vec2 a, Vec2 b) {
    const Vec2 d = b - a;
    double t0 = 0.0, t1 = 1.0;
    for (const auto &[step, room] : {std::pair(-d.x, a.x - box.min.x), std::pair(d.x, box.max.x - a.x),
                                     std::pair(-d.y, a.y - box.min.y), std::pair(d.y, box.max.y - a.y)}) {
        if (step == 0.0 && room < 0.0) {
            return std::nullopt;
        }
        if (step < 0.0) {
            t0 = std::max(t0, room / step);
        } else if (step > 0.0) {
            t1 = std::min(t1, room / step);
        }
    }
    return t0 < t1 ? std::optional(std::pair(a + t0 * d, a + t1 * d)) : std::nullopt;
}

/// Writes the lengths, radii and angles of the drawing, or of the selected shapes.
class DimensionsLayer final : public Layer {
  public:
    const char *id() const override { return "dimensions"; }
    const char *name() const override { return "Dimensions"; }

    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        if (revision_ != frame.revision) {
            revision_ = frame.revision;
            dimensions_ = dimensionsOf(frame.document);
            findDriving(frame.document);
        }
        for (const Dimension *dimension : inView(frame)) {
            if (dimension->kind == DimensionKind::Length) {
                drawLength(painter, frame, *dimension);
            } else if (dimension->kind == DimensionKind::Angle) {
                drawAngle(painter, frame, *dimension);
            } else {
                drawRadius(painter, frame, *dimension);
            }
        }
    }

  private:
    /// The places and the shape by which a dimension and the constraint that drives it are the same.
    using Key = std::tuple<double, double, double, double, std::uint32_t>;

    /// Returns the key of a length between two places, in either order.
    static Key lengthKey(Vec2 a, Vec2 b) {
        const auto [low, high] = std::minmax({std::pair(a.x, a.y), std::pair(b.x, b.y)});
        return {low.first, low.second, high.first, high.second, 0};
    }

    static Key radiusKey(Vec2 centre, std::uint32_t shape) { return {centre.x, centre.y, 0.0, 0.0, shape}; }

    /// Finds the dimensions that constraints drive, which the layer Sketch draws.
    void findDriving(const Document &document) {
        std::set<Key> lengths, radii;
        for (const auto &constraint : document.constraints) {
            const std::optional<DimensionFigure> figure = dimensionFigure(document, *constraint);
            if (figure && constraint->kind == ConstraintKind::Length) {
                lengths.insert(lengthKey(figure->from, figure->to));
            }
            if (figure && figure->form == DimensionFigure::Form::Radial) {
                radii.insert(radiusKey(figure->from, constraint->parts[0].shape));
            }
        }
        driving_.assign(dimensions_.size(), false);
        for (std::size_t k = 0; k < dimensions_.size(); ++k) {
            const Dimension &own = dimensions_[k];
            driving_[k] = (own.kind == DimensionKind::Length && lengths.contains(lengthKey(own.from, own.to))) ||
                          (own.kind == DimensionKind::Radius && radii.contains(radiusKey(own.from, own.shape)));
        }
    }

    /// Returns the dimensions to draw: the longest in view, angles last.
    std::vector<const Dimension *> inView(const LayerFrame &frame) const {
        const Box2 visible = frame.camera.visible();
        const Selection &selection = frame.selection;
        const bool some = !(selection.shapes.empty() && selection.nodes.empty() && selection.segments.empty());
        const double least = frame.camera.length(kLeastExtent * frame.scale);
        const bool sketch = frame.visible("sketch");
        std::vector<const Dimension *> found;
        for (const Dimension &dimension : dimensions_) {
            if (sketch && driving_[static_cast<std::size_t>(&dimension - dimensions_.data())]) {
                continue;
            }
            const bool angle = dimension.kind == DimensionKind::Angle;
            if (dimension.extent >= least &&
                (angle ? visible.contains(dimension.from) : boxOf(dimension.from, dimension.to).overlaps(visible)) &&
                (some ? selection.touches(dimension.shape) : !angle)) {
                found.push_back(&dimension);
            }
        }
        const auto first = [](const Dimension *a, const Dimension *b) {
            const bool angleA = a->kind == DimensionKind::Angle, angleB = b->kind == DimensionKind::Angle;
            return angleA != angleB ? angleB : a->extent != b->extent ? a->extent > b->extent : a < b;
        };
        const auto drawn = static_cast<std::ptrdiff_t>(std::min(found.size(), kMaxDimensions));
        std::partial_sort(found.begin(), found.begin() + drawn, found.end(), first);
        found.resize(static_cast<std::size_t>(drawn));
        return found;
    }

    /// Returns the part of the plane for middles of texts, so that none is cut off at the edge of the canvas.
    static Box2 roomFor(const LayerFrame &frame) {
        const PixelRect &canvas = frame.camera.viewport;
        const double margin = std::min(kEdgeMargin * frame.scale, 0.25 * std::min(canvas.width, canvas.height));
        return frame.camera.visible().grown(-frame.camera.length(margin));
    }

    /// Returns the size of a text in design pixels.
    static Pixel sizeOf(const std::string &text, const LayerFrame &frame) {
        ImFont &font = *frame.fonts.small;
        const ImVec2 size = font.CalcTextSizeA(imgui::lineOf(font), 1e9F, 0.0F, text.data(), text.data() + text.size());
        return Pixel(size.x, size.y) / frame.scale;
    }

    /// Returns the offset of a text of some size that lies beside a line in direction `side`, of length 1 on the
    /// screen; both in design pixels.
    static Pixel offsetBeside(Pixel size, Pixel side) {
        const Pixel half = 0.5 * size;
        const double reach =
            std::abs(side.x) * (half.x + kPlateRim) + std::abs(side.y) * (half.y + 0.5 * kPlateRim) + kTextGap;
        return reach * side - half;
    }

    static bool write(CanvasPainter &painter, const LayerFrame &frame, Vec2 at, std::span<const Pixel> offsets,
                      const std::string &text) {
        return painter.freeLabel(at, offsets, text, frame.theme.muted, labelPlate(frame.theme), frame.fonts.small);
    }

    /// Returns the direction of a displacement in the plane on the screen.
    static Pixel directionOf(Vec2 way) {
        const double size = length(way);
        return {way.x / size, -way.y / size};
    }

    static void drawLength(CanvasPainter &painter, const LayerFrame &frame, const Dimension &dimension) {
        const auto part = partInside(roomFor(frame), dimension.from, dimension.to);
        if (!part) {
            return;
        }
        const auto [from, to] = *part;
        const std::string text = textOf(dimension);
        const Pixel size = sizeOf(text, frame);
        const double room = frame.camera.zoom * distance(from, to) / frame.scale;
        if (room < size.x + 2.0 * kPlateRim) {
            return;
        }
        const Pixel along = directionOf(to - from), outside{-along.y, along.x};
        std::vector<Pixel> offsets;
        for (const double shift : {0.0, -0.15, 0.15}) { // off the middle if a handle or another text is there
            for (const Pixel side : {outside, -outside}) {
                offsets.push_back(offsetBeside(size, side) + shift * room * along);
            }
        }
        write(painter, frame, midpoint(from, to), offsets, text);
    }

    /// Draws a radius with a thin line from the centre.
    static void drawRadius(CanvasPainter &painter, const LayerFrame &frame, const Dimension &dimension) {
        const std::string text = textOf(dimension);
        const Pixel size = sizeOf(text, frame);
        if (frame.camera.zoom * dimension.extent / frame.scale < size.x + 2.0 * kPlateRim) {
            return;
        }
        const Pixel way = directionOf(dimension.to - dimension.from), side{way.y, -way.x};
        const Box2 room = roomFor(frame);
        bool drawn = false;
        if (dimension.kind == DimensionKind::Radius && room.contains(dimension.to)) {
            const Pixel back = -0.5 * (frame.camera.zoom * dimension.value / frame.scale) * way;
            std::vector<Pixel> offsets{offsetBeside(size, way), back + offsetBeside(size, side),
                                       back + offsetBeside(size, -side)};
            for (const double away : {16.0, 32.0, 48.0, 64.0}) { // clear of the handles of a selected circle
                for (const Pixel aside : {Pixel{}, away * side, -away * side}) {
                    offsets.push_back(offsetBeside(size, way) + away * way + aside);
                }
            }
            drawn = write(painter, frame, dimension.to, offsets, text);
        } else if (const auto part = partInside(room, dimension.from, dimension.to)) {
            drawn = write(painter, frame, midpoint(part->first, part->second),
                          std::array{offsetBeside(size, side), offsetBeside(size, -side)}, text);
        }
        if (drawn) {
            painter.line(dimension.from, dimension.to, fade(frame.theme.muted, 0.55), 1.0);
            painter.dot(dimension.from, 2.0, frame.theme.muted);
        }
    }

    /// Draws an angle with a small arc between its legs.
    static void drawAngle(CanvasPainter &painter, const LayerFrame &frame, const Dimension &dimension) {
        if (frame.camera.zoom * dimension.extent < kLeastLeg * frame.scale) {
            return;
        }
        const Vec2 leg = dimension.to - dimension.from;
        const double begin = std::atan2(leg.y, leg.x), sweep = dimension.value * std::numbers::pi / 180.0;
        const double middle = begin + 0.5 * sweep;
        const std::string text = textOf(dimension);
        const Pixel way{std::cos(middle), -std::sin(middle)};
        const Pixel offset = offsetBeside(sizeOf(text, frame), way) + kAngleArc * way;
        if (!write(painter, frame, dimension.from, std::array{offset, offset + 14.0 * way, offset + 28.0 * way},
                   text)) {
            return;
        }
        const double radius = frame.camera.length(kAngleArc * frame.scale);
        std::vector<Vec2> arc;
        constexpr int kPieces = 24;
        for (int k = 0; k <= kPieces; ++k) {
            const double angle = begin + sweep * k / kPieces;
            arc.push_back(dimension.from + radius * Vec2{std::cos(angle), std::sin(angle)});
        }
        painter.polyline(arc, false, fade(frame.theme.muted, 0.8), 1.0);
    }

    std::vector<Dimension> dimensions_; ///< of the document with revision_
    std::vector<bool> driving_;         ///< for each of them, whether a constraint drives it
    std::uint64_t revision_ = 0;
};

} // namespace

std::unique_ptr<Layer> makeDimensionsLayer() {
    return std::make_unique<DimensionsLayer>();
}

} // namespace forefront
