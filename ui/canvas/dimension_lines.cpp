#include "ui/canvas/dimension_lines.hpp"

#include "ui/canvas/label_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
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
constexpr double kLevel = 22.0;                   ///< between a place of the text and the next one further out
constexpr int kLevels = 5, kOutsideLevels = 8;    ///< such places beside what is measured, and beside its shapes
/// Distance from what is measured up to which a text goes outside of the shapes in any case.
constexpr double kFarFromMeasured = 160.0;

class DimensionDrawer {
  public:
    DimensionDrawer(CanvasPainter &painter, DimensionRoom &room, const DimensionFigure &figure, const std::string &text,
                    const DimensionStyle &style)
        : painter_(painter), room_(room), figure_(figure), text_(text), style_(style),
          size_(painter.labelSize(text, style.font)) {}

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

    /// Returns the first offset at which the text covers nothing, its line runs along no other dimension line, and
    /// neither meets what the other dimensions have; without such an offset, the first at which the text covers
    /// nothing.
    std::optional<Pixel> found() const {
        const std::vector<Pixel> offsets = figure_.form == DimensionFigure::Form::Linear   ? linearOffsets()
                                           : figure_.form == DimensionFigure::Form::Radial ? radialOffsets()
                                                                                           : angularOffsets();
        for (const Pixel &offset : offsets) {
            if (keepsClear(offset) && painter_.freeOffset(base(), {&offset, 1}, text_, style_.font)) {
                return offset;
            }
        }
        return painter_.freeOffset(base(), offsets, text_, style_.font);
    }

    /// Returns a direction in the plane as one on the screen.
    static Pixel turned(Vec2 way) { return {way.x, -way.y}; }
    /// Returns how far the text reaches from its middle in a direction.
    double reachOf(Pixel way) const { return std::abs(way.x) * 0.5 * size_.x + std::abs(way.y) * 0.5 * size_.y; }

    /// Returns offsets outside of the shapes, unless these reach far beyond what is measured, then beside it.
    std::vector<Pixel> linearOffsets() const {
        std::vector<Pixel> offsets;
        const Pixel out = turned(figure_.outward), along = turned(figure_.along);
        const double measured = pixels(distance(figure_.from, figure_.to));
        const double least = std::max(kLeastDistance, reachOf(out) + 6.0);
        const auto add = [&](double away) {
            for (const double share : {0.0, 0.2, -0.2}) {
                offsets.push_back(offsetOf(away * out + share * measured * along));
            }
        };
        const double clear = pixels(figure_.clear), behind = pixels(figure_.clearBehind);
        const double farthest = std::max(kFarFromMeasured, 2.0 * measured);
        for (int level = 0; level < kOutsideLevels; ++level) {
            for (const double side : {1.0, -1.0}) {
                const double rim = side > 0.0 ? clear : behind;
                if (rim <= farthest) {
                    add(side * (rim + least + level * kLevel));
                }
            }
        }
        for (int level = 0; level < kLevels; ++level) {
            for (const double side : {1.0, -1.0}) {
                add(side * (least + level * kLevel));
            }
        }
        return offsets;
    }

    /// Returns offsets beyond the arc, in directions that the arc has.
    std::vector<Pixel> radialOffsets() const {
        std::vector<Pixel> offsets;
        const bool whole = std::abs(figure_.sweep) > 2.0 * std::numbers::pi - 1e-6;
        const double radius = pixels(distance(figure_.from, figure_.to));
        for (int level = 0; level < kLevels; ++level) {
            for (const double share :
                 whole ? std::array{0.0, 0.5, 0.25, 0.75, 0.125} : std::array{0.5, 0.3, 0.7, 0.1, 0.9}) {
                const Pixel way = turned(figure_.wayAt(share));
                offsets.push_back(offsetOf((radius + kLeastDistance + reachOf(way) + level * kLevel) * way));
            }
        }
        return offsets;
    }

    std::vector<Pixel> angularOffsets() const {
        std::vector<Pixel> offsets;
        const Pixel out = turned(figure_.outward); // beyond the apex is another angle
        const double least = std::min(36.0, 0.6 * pixels(distance(figure_.from, figure_.to)));
        for (int level = 0; level < kLevels; ++level) {
            offsets.push_back(offsetOf((least + reachOf(out) + level * kLevel) * out));
        }
        return offsets;
    }

    /// Returns the ends of the dimension line or arm for a text at a place.
    std::pair<Vec2, Vec2> lineAt(Vec2 place) const {
        if (figure_.form == DimensionFigure::Form::Linear) {
            const Vec2 normal = leftNormal(figure_.along);
            const auto footOf = [&](Vec2 p) { return p + dot(place - p, normal) * normal; };
            return {footOf(figure_.from), footOf(figure_.to)};
        }
        return {figure_.from, place};
    }

    bool keepsClear(Pixel offset) const {
        const Vec2 place = placeAt(offset);
        const Camera &camera = painter_.camera();
        const Pixel middle = camera.toPixel(place), size = painter_.scale() * size_;
        if (!room_.isTextFree({middle.x - 0.5 * size.x, middle.y - 0.5 * size.y, size.x, size.y})) {
            return false;
        }
        if (figure_.form == DimensionFigure::Form::Angular) {
            return true;
        }
        const auto [from, to] = lineAt(place);
        const Pixel a = camera.toPixel(from), b = camera.toPixel(to);
        const bool alone = figure_.form == DimensionFigure::Form::Radial || room_.isLineFree(a, b);
        const auto &labels = painter_.labels();
        return alone && std::none_of(labels.begin(), labels.end(),
                                     [&](const CanvasPainter::Placed &label) { return meets(label.rect, a, b); });
    }

    void take(Vec2 a, Vec2 b) { room_.takeSide(painter_.camera().toPixel(a), painter_.camera().toPixel(b)); }
    void line(Vec2 a, Vec2 b) { painter_.line(a, b, style_.colour, kDimensionWidth); }
    void arrow(Vec2 from, Vec2 to) { painter_.arrow(from, to, style_.colour, kDimensionWidth, kHead); }

    /// Draws the line from what is measured to the dimension line and a little beyond.
    void extension(std::array<Vec2, 2> measured, Vec2 to) {
        const Vec2 from = distance(measured[0], to) <= distance(measured[1], to) ? measured[0] : measured[1];
        const double size = distance(from, to);
        if (pixels(size) > kFromPart) {
            const Vec2 way = (1.0 / size) * (to - from);
            painter_.line(from + plane(kFromPart) * way, to + plane(kExtension) * way, fade(style_.colour, 0.6),
                          kDimensionWidth);
            take(from, to);
        }
    }

    void drawLinear(Vec2 place) {
        const std::pair<Vec2, Vec2> ends = lineAt(place);
        const Vec2 a = ends.first, b = ends.second, middle = midpoint(a, b);
        room_.takeLine(painter_.camera().toPixel(a), painter_.camera().toPixel(b));
        extension(figure_.fromLine, a);
        extension(figure_.toLine, b);
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
            take(at < 0.0 ? a : b, place);
        }
    }

    void drawRadial(Vec2 place) {
        const Vec2 arm = place - figure_.from;
        const double size = length(arm), radius = distance(figure_.from, figure_.to);
        const Vec2 wanted = size > 0.0 ? (1.0 / size) * arm : figure_.along, way = figure_.wayOnArc(wanted);
        const Vec2 rim = figure_.from + radius * way;
        const bool aside = dot(way, wanted) < 1.0 - 1e-9; // the text lies where the arc is not
        if (figure_.diameter) {
            const Vec2 other = figure_.from - radius * way;
            arrow(figure_.from, rim);
            const bool whole = dot(figure_.wayOnArc(-1.0 * way), way) < -1.0 + 1e-9;
            whole ? arrow(figure_.from, other) : line(figure_.from, other);
        } else {
            arrow(figure_.from, rim);
            painter_.dot(figure_.from, 2.0, style_.colour);
        }
        take(figure_.from, rim);
        if (size > radius || aside) {
            line(rim, place);
            take(rim, place);
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
    DimensionRoom &room_;
    const DimensionFigure &figure_;
    const std::string &text_;
    const DimensionStyle &style_;
    Pixel size_; ///< of the text with its plate, design pixels
};

} // namespace

std::optional<Pixel> drawDimension(CanvasPainter &painter, DimensionRoom &room, const DimensionFigure &figure,
                                   std::optional<Vec2> label, const std::string &text, const DimensionStyle &style) {
    return DimensionDrawer(painter, room, figure, text, style).draw(label);
}

} // namespace forefront
