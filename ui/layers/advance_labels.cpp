#include "ui/layers/advance_labels.hpp"

#include "core/teaching/moment/moment.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/canvas/near_front.hpp"
#include "ui/parts/layer.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace forefront {
namespace {

using PixelLine = std::pair<Pixel, Pixel>;

/// What the label of a point of the advance should not cover, in pixels.
struct AdvanceMarks {
    std::vector<PixelLine> lines;
    std::vector<Pixel> points;
};

constexpr double kMarkReach = 160.0; // of marks around a point, design pixels; more than a label is away from it

/// Collects the marks in a box.
class MarkCollector {
  public:
    MarkCollector(const Camera &camera, const Box2 &box) : camera_(camera), box_(box) {}

    void line(Vec2 a, Vec2 b) {
        Box2 box;
        box.add(a);
        box.add(b);
        if (box.overlaps(box_)) {
            marks_.lines.emplace_back(camera_.toPixel(a), camera_.toPixel(b));
        }
    }
    void point(Vec2 p) {
        if (box_.contains(p)) {
            marks_.points.push_back(camera_.toPixel(p));
        }
    }
    AdvanceMarks take() { return std::move(marks_); }

  private:
    const Camera &camera_;
    Box2 box_;
    AdvanceMarks marks_;
};

/// Returns the marks around A, B and C: the front, what the advance has made, and its candidates with the lines to
/// them.
AdvanceMarks marksAround(const LayerFrame &frame, const Moment &moment) {
    const AdvanceExplanation &e = *moment.advance;
    Box2 box;
    for (const Vec2 point : {e.a, e.b, e.ideal}) {
        const Box2 around = boxAround(point, frame.camera.length(kMarkReach * frame.scale));
        box.add(around.min);
        box.add(around.max);
    }
    MarkCollector marks(frame.camera, box);
    if (frame.snapshot.front && frame.visible("front")) {
        for (const auto &[a, b] : frame.nearFront.within(frame.snapshot.front, box)) {
            marks.line(a, b);
        }
    }
    marks.line(e.a, e.b);
    marks.point(e.a);
    marks.point(e.b);
    if (moment.idealKnown) {
        marks.point(e.ideal);
    }
    for (std::size_t i = 0; moment.candidatesKnown && i < moment.candidates; ++i) {
        marks.point(e.candidates[i].position);
        if (moment.judged[i]) {
            marks.line(e.a, e.candidates[i].position);
            marks.line(e.b, e.candidates[i].position);
        }
    }
    for (const auto &[p, q, r] : moment.updated ? e.made : std::vector<std::array<Vec2, 3>>()) {
        marks.line(p, q);
        marks.line(q, r);
        marks.line(r, p);
    }
    return marks.take();
}

/// Returns how much a rectangle covers: a point counts as two lines.
double covered(const AdvanceMarks &marks, const PixelRect &rect, double rim) {
    const PixelRect wide{rect.x - rim, rect.y - rim, rect.width + 2.0 * rim, rect.height + 2.0 * rim};
    const auto lines = std::count_if(marks.lines.begin(), marks.lines.end(),
                                     [&](const PixelLine &line) { return meets(rect, line.first, line.second); });
    const auto points =
        std::count_if(marks.points.begin(), marks.points.end(), [&](Pixel p) { return wide.contains(p); });
    return static_cast<double>(lines) + 2.0 * static_cast<double>(points);
}

/// Returns true if a rectangle is within `rim` pixels of the edge of the canvas, or beyond.
bool touchesEdge(const PixelRect &canvas, const PixelRect &rect, double rim) {
    return rect.x < canvas.x + rim || rect.y < canvas.y + rim || rect.x + rect.width > canvas.x + canvas.width - rim ||
           rect.y + rect.height > canvas.y + canvas.height - rim;
}

} // namespace

void labelOfAdvance(CanvasPainter &painter, const LayerFrame &frame, const Moment &moment, const AdvanceLabel &label) {
    const Vec2 at = label.at;
    const std::string &text = label.text;
    ImFont *const font = frame.fonts.small;
    const AdvanceMarks marks = marksAround(frame, moment);
    const Pixel place = painter.camera().toPixel(at);
    const PixelRect atPlace = painter.labelRect(at, {}, text, font);
    const Pixel half = 0.5 / frame.scale * Pixel(atPlace.width, atPlace.height);
    const Pixel shift = (atPlace.centre() - place) / frame.scale;
    const double ahead = std::atan2(-label.away.y, label.away.x); // on the screen, y points down

    constexpr int kDirections = 16;
    constexpr double kRims[] = {7.0, 19.0, 32.0}; // from the point to the label, design pixels
    constexpr double kPointRim = 6.0;             // radius of what marks a point
    constexpr double kEdgeRim = 4.0;              // of the canvas
    double best = std::numeric_limits<double>::infinity();
    std::optional<Pixel> found;
    bool beside = true;
    for (const double rim : kRims) {
        for (int k = 0; k < kDirections; ++k) {
            const int turn = k % 2 == 0 ? k / 2 : -(k + 1) / 2; // to both sides by turns
            const double angle = ahead + 2.0 * std::numbers::pi * turn / kDirections;
            const Pixel ray{std::cos(angle), std::sin(angle)};
            const Pixel offset = (rim + std::abs(ray.x) * half.x + std::abs(ray.y) * half.y) * ray - shift;
            const PixelRect rect = painter.labelRect(at, offset, text, font);
            const double cost = covered(marks, rect, kPointRim * frame.scale) + 0.04 * std::abs(turn) +
                                0.02 * (rim - kRims[0]) +
                                (touchesEdge(frame.camera.viewport, rect, kEdgeRim * frame.scale) ? 0.8 : 0.0);
            if (cost < best && painter.freeOffset(at, std::span(&offset, 1), text, font)) {
                best = cost;
                found = offset;
                beside = rim == kRims[0];
            }
        }
    }
    if (!found && label.optional) {
        return;
    }
    painter.label(at, found.value_or(Pixel(10.0, -24.0)), text, label.colour, labelPlate(frame.theme), font);
    if (!beside) {
        painter.leader(at, label.colour);
    }
}

} // namespace forefront
