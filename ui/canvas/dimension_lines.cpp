#include "ui/canvas/dimension_lines.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace forefront {
namespace {

constexpr double kLeastMeasured = 14.0;           ///< extent of what is measured, design pixels
constexpr double kHead = 7.0;                     ///< length of an arrowhead
constexpr double kRoomForHeads = 26.0;            ///< between extension lines; nearer ones get arrows from outside
constexpr double kExtension = 4.0;                ///< of an extension line beyond the dimension line
constexpr double kFromPart = 3.0;                 ///< between a part and its extension line
constexpr double kDimensionWidth = 1.0;           ///< of all lines
constexpr double kLeastDistance = 24.0;           ///< of the text from what is measured
constexpr double kTextRim = 5.0, kTextRimY = 2.0; ///< of the plate around a text

class DimensionDrawer {
  public:
    DimensionDrawer(CanvasPainter &painter, const DimensionFigure &figure, const std::string &text,
                    const DimensionStyle &style)
        : painter_(painter), figure_(figure), text_(text), style_(style), size_(painter.labelSize(text, style.font)) {}

    std::optional<Pixel> draw(std::optional<Vec2> label) {
        const Box2 visible = painter_.camera().visible();
        Box2 box = boxOf(figure_.from, figure_.to);
        if (label) {
            box.add(figure_.placeOf(*label));
        }
        const bool small = pixels(distance(figure_.from, figure_.to)) < kLeastMeasured;
        if (!box.overlaps(visible) || (small && !style_.chosen && !label)) {
            return std::nullopt;
        }
        const std::optional<Pixel> offset = style_.kept ? style_.kept
                                            : label     ? placed(figure_.placeOf(*label))
                                                        : found();
        if (!offset) {
            return std::nullopt;
        }
        const Vec2 place = placeAt(*offset);
        switch (figure_.form) {
        case DimensionFigure::Form::Linear:
            drawLinear(place);
            break;
        case DimensionFigure::Form::Radial:
            drawRadial(place);
            break;
        case DimensionFigure::Form::Angular:
            drawAngular(place);
            break;
        }
        if (style_.kept) {
            painter_.fixedLabel(base(), *offset, text_, style_.colour, style_.plate, style_.font);
            return offset;
        }
        return painter_.offsetOf(base(),
                                 painter_.label(base(), *offset, text_, style_.colour, style_.plate, style_.font));
    }

  private:
    double pixels(double length) const { return painter_.camera().zoom * length / painter_.scale(); }
    double plane(double designPixels) const { return painter_.camera().length(designPixels * painter_.scale()); }

    /// Returns the place that offsets of the text start from.
    Vec2 base() const {
        return figure_.form == DimensionFigure::Form::Linear ? midpoint(figure_.from, figure_.to) : figure_.from;
    }
    /// Returns the offset of a text whose middle is at a displacement from base(), in design pixels on the screen.
    Pixel offsetOf(Pixel middle) const { return middle - 0.5 * size_ + Pixel(kTextRim, kTextRimY); }
    Pixel onScreen(Vec2 way) const { return {pixels(way.x), -pixels(way.y)}; }
    /// Returns the middle of a text with an offset.
    Vec2 placeAt(Pixel offset) const {
        const Pixel middle = offset - Pixel(kTextRim, kTextRimY) + 0.5 * size_;
        return base() + Vec2{plane(middle.x), -plane(middle.y)};
    }

    Pixel placed(Vec2 place) const { return offsetOf(onScreen(place - base())); }

    /// Returns the first offset at which the text covers nothing.
    std::optional<Pixel> found() const {
        std::vector<Pixel> offsets;
        const Pixel out{figure_.outward.x, -figure_.outward.y}, along{figure_.along.x, -figure_.along.y};
        const double reach = std::abs(out.x) * 0.5 * size_.x + std::abs(out.y) * 0.5 * size_.y;
        const double least = figure_.form == DimensionFigure::Form::Linear ? kLeastDistance
                             : figure_.form == DimensionFigure::Form::Radial
                                 ? pixels(distance(figure_.from, figure_.to)) + kLeastDistance
                                 : std::min(36.0, 0.6 * pixels(distance(figure_.from, figure_.to)));
        for (const double level : {0.0, 20.0, 40.0, 60.0, 80.0}) {
            for (const double side : {1.0, -1.0}) {
                if (side < 0.0 && figure_.form == DimensionFigure::Form::Angular) {
                    continue; // beyond the apex is another angle
                }
                const double away = figure_.form == DimensionFigure::Form::Linear ? std::max(least, reach + 6.0) + level
                                                                                  : least + reach + level;
                offsets.push_back(offsetOf(side * away * out));
                for (const double shift : {0.2, -0.2}) {
                    if (figure_.form == DimensionFigure::Form::Linear) {
                        const double share = shift * pixels(distance(figure_.from, figure_.to));
                        offsets.push_back(offsetOf(side * away * out + share * along));
                    }
                }
            }
        }
        return painter_.freeOffset(base(), offsets, text_, style_.font);
    }

    void line(Vec2 a, Vec2 b) { painter_.line(a, b, style_.colour, kDimensionWidth); }
    void arrow(Vec2 from, Vec2 to) { painter_.arrow(from, to, style_.colour, kDimensionWidth, kHead); }

    /// Draws the line from a measured place to the dimension line and a little beyond.
    void extension(Vec2 from, Vec2 to) {
        const double size = distance(from, to);
        if (pixels(size) > kFromPart) {
            const Vec2 way = (1.0 / size) * (to - from);
            painter_.line(from + plane(kFromPart) * way, to + plane(kExtension) * way, fade(style_.colour, 0.6),
                          kDimensionWidth);
        }
    }

    void drawLinear(Vec2 place) {
        const Vec2 normal = leftNormal(figure_.along);
        const auto footOf = [&](Vec2 p) { return p + dot(place - p, normal) * normal; };
        const Vec2 a = footOf(figure_.from), b = footOf(figure_.to), middle = midpoint(a, b);
        extension(figure_.from, a);
        extension(figure_.to, b);
        if (pixels(distance(a, b)) >= kRoomForHeads) {
            arrow(middle, a);
            arrow(middle, b);
        } else {
            line(a, b);
            arrow(a - plane(2.0 * kHead) * figure_.along, a);
            arrow(b + plane(2.0 * kHead) * figure_.along, b);
        }
        // A text aside of the two places has a line to them.
        const double at = dot(place - a, figure_.along), whole = dot(b - a, figure_.along);
        if (at < 0.0 || at > whole) {
            line(at < 0.0 ? a : b, place);
        }
    }

    void drawRadial(Vec2 place) {
        const Vec2 arm = place - figure_.from;
        const double size = length(arm), radius = distance(figure_.from, figure_.to);
        const Vec2 way = size > 0.0 ? (1.0 / size) * arm : figure_.along;
        const Vec2 rim = figure_.from + radius * way;
        if (figure_.diameter) {
            const Vec2 other = figure_.from - radius * way;
            arrow(figure_.from, rim);
            arrow(figure_.from, other);
        } else {
            arrow(figure_.from, rim);
            painter_.dot(figure_.from, 2.0, style_.colour);
        }
        if (size > radius) {
            line(rim, place);
        }
    }

    void drawAngular(Vec2 place) {
        const double radius = distance(figure_.from, place);
        const auto at = [&](double share) {
            const double angle = figure_.begin + share * figure_.sweep;
            return figure_.from + radius * Vec2{std::cos(angle), std::sin(angle)};
        };
        constexpr int kPieces = 32;
        std::vector<Vec2> arc;
        for (int k = 0; k <= kPieces; ++k) {
            arc.push_back(at(static_cast<double>(k) / kPieces));
        }
        painter_.polyline(arc, false, style_.colour, kDimensionWidth);
        if (pixels(radius * std::abs(figure_.sweep)) >= kRoomForHeads) {
            const double head = plane(kHead) / (radius * std::abs(figure_.sweep));
            arrow(at(head), at(0.0));
            arrow(at(1.0 - head), at(1.0));
        }
        for (const double share : {0.0, 1.0}) { // the legs as far as the arc
            painter_.line(figure_.from, at(share), fade(style_.colour, 0.6), kDimensionWidth);
        }
    }

    CanvasPainter &painter_;
    const DimensionFigure &figure_;
    const std::string &text_;
    const DimensionStyle &style_;
    Pixel size_; ///< of the text with its plate, design pixels
};

} // namespace

std::optional<Pixel> drawDimension(CanvasPainter &painter, const DimensionFigure &figure, std::optional<Vec2> label,
                                   const std::string &text, const DimensionStyle &style) {
    return DimensionDrawer(painter, figure, text, style).draw(label);
}

} // namespace forefront
