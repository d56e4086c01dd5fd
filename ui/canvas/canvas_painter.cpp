#include "ui/canvas/canvas_painter.hpp"

#include "core/drawing/shapes/shape_geometry.hpp"
#include "ui/canvas/label_offsets.hpp"
#include "ui/style/imgui_versions.hpp"

#include <glm/common.hpp>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace forefront {

namespace {

// Maximum coordinate in pixels; farther out, floats lose the direction of a line.
constexpr double kFar = 1.0e5;

bool clipToFar(Pixel &a, Pixel &b) {
    // Liang–Barsky against the square [-kFar, kFar]².
    const Pixel d = b - a;
    double t0 = 0.0, t1 = 1.0;
    const double p[4] = {-d.x, d.x, -d.y, d.y};
    const double q[4] = {a.x + kFar, kFar - a.x, a.y + kFar, kFar - a.y};
    for (int i = 0; i < 4; ++i) {
        if (p[i] == 0.0) {
            if (q[i] < 0.0) {
                return false;
            }
        } else if (p[i] < 0.0) {
            t0 = std::max(t0, q[i] / p[i]);
        } else {
            t1 = std::min(t1, q[i] / p[i]);
        }
    }
    if (!(t0 <= t1)) {
        return false;
    }
    const Pixel from = a;
    a = from + t0 * d;
    b = from + t1 * d;
    return true;
}

ImVec2 im(Pixel p) {
    const glm::vec2 near(glm::clamp(p, -kFar, kFar));
    return {near.x, near.y};
}

float im(double v) {
    return static_cast<float>(v);
}

} // namespace

void CanvasPainter::beginLevels() {
    list_.ChannelsSplit(static_cast<int>(Level::Labels) + 1);
    setLevel(Level::Layers);
}

void CanvasPainter::setLevel(Level level) {
    level_ = level;
    list_.ChannelsSetCurrent(static_cast<int>(level));
}

void CanvasPainter::endLevels() {
    list_.ChannelsMerge();
    level_.reset();
}

template <class Draw>
void CanvasPainter::aboveLines(const Draw &draw) {
    const std::optional<Level> level = level_;
    if (level) {
        setLevel(Level::Labels);
    }
    draw();
    if (level) {
        setLevel(*level);
    }
}

void CanvasPainter::line(Vec2 a, Vec2 b, Colour colour, double width) {
    Pixel p = camera_.toPixel(a), q = camera_.toPixel(b);
    if (clipToFar(p, q)) {
        list_.AddLine(im(p), im(q), colour, im(width * scale_));
    }
}

void CanvasPainter::dashed(Vec2 a, Vec2 b, Colour colour, double width, double dash) {
    Pixel p = camera_.toPixel(a), q = camera_.toPixel(b);
    if (!clipToFar(p, q)) {
        return;
    }
    const double whole = glm::distance(p, q), stride = 2.0 * dash * scale_;
    if (whole < stride || whole / stride > 2000.0) {
        list_.AddLine(im(p), im(q), colour, im(width * scale_));
        return;
    }
    const int dashes = static_cast<int>(std::ceil(whole / stride));
    for (int k = 0; k < dashes; ++k) {
        const double at = stride * k, end = std::min(at + 0.5 * stride, whole);
        list_.AddLine(im(glm::mix(p, q, at / whole)), im(glm::mix(p, q, end / whole)), colour, im(width * scale_));
    }
}

void CanvasPainter::arrow(Vec2 a, Vec2 b, Colour colour, double width, double head) {
    Pixel p = camera_.toPixel(a), q = camera_.toPixel(b);
    if (!clipToFar(p, q)) {
        return;
    }
    const double whole = glm::distance(p, q);
    const double size = std::min(head * scale_, 0.45 * whole);
    if (size < 2.0) {
        list_.AddLine(im(p), im(q), colour, im(width * scale_));
        return;
    }
    const Pixel along = (1.0 / whole) * (q - p);
    const Pixel neck = q - size * along, side = 0.42 * size * Pixel(-along.y, along.x);
    list_.AddLine(im(p), im(neck), colour, im(width * scale_));
    list_.AddTriangleFilled(im(q), im(neck + side), im(neck - side), colour);
}

void CanvasPainter::polyline(std::span<const Vec2> points, bool closed, Colour colour, double width) {
    if (points.size() < 2) {
        return;
    }
    std::vector<ImVec2> pixels;
    pixels.reserve(points.size());
    for (const Vec2 p : points) {
        pixels.push_back(im(camera_.toPixel(p)));
    }
    list_.AddPolyline(pixels.data(), static_cast<int>(pixels.size()), colour, closed ? ImDrawFlags_Closed : 0,
                      im(width * scale_));
}

void CanvasPainter::addAlong(const Curve &curve, double width, std::vector<Vec2> &points) const {
    const Box2 box = camera_.visible().grown(camera_.length(width * scale_));
    for (const double t : curve.flattenWithin(box, camera_.length(0.2 * scale_))) {
        points.push_back(curve.point(t));
    }
}

void CanvasPainter::curve(const Curve &curve, Colour colour, double width) {
    std::vector<Vec2> points = {curve.point(0.0)};
    addAlong(curve, width, points);
    polyline(points, false, colour, width);
}

void CanvasPainter::outline(const Outline &outline, Colour colour, double width) {
    std::vector<Vec2> points;
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        points.push_back(outline.from(k));
        if (outline.isCurved(k)) {
            addAlong(outline.curves[k], width, points);
            points.pop_back(); // the next node
        }
    }
    if (outline.segmentCount() < outline.nodes.size()) {
        points.push_back(outline.nodes.back());
    }
    polyline(points, outline.closed, colour, width);
}

void CanvasPainter::triangle(Vec2 a, Vec2 b, Vec2 c, Colour fill) {
    list_.AddTriangleFilled(im(camera_.toPixel(a)), im(camera_.toPixel(b)), im(camera_.toPixel(c)), fill);
}

void CanvasPainter::quadrilateral(const std::array<Vec2, 4> &corners, Colour fill) {
    list_.AddQuadFilled(im(camera_.toPixel(corners[0])), im(camera_.toPixel(corners[1])),
                        im(camera_.toPixel(corners[2])), im(camera_.toPixel(corners[3])), fill);
}

void CanvasPainter::rectangle(const Box2 &box, Colour colour, double width) {
    list_.AddRect(im(camera_.toPixel({box.min.x, box.max.y})), im(camera_.toPixel({box.max.x, box.min.y})), colour,
                  0.0F, 0, im(width * scale_));
}

void CanvasPainter::fillRectangle(const Box2 &box, Colour fill) {
    list_.AddRectFilled(im(camera_.toPixel({box.min.x, box.max.y})), im(camera_.toPixel({box.max.x, box.min.y})), fill);
}

void CanvasPainter::dot(Vec2 centre, double radius, Colour fill) {
    list_.AddCircleFilled(im(camera_.toPixel(centre)), im(radius * scale_), fill);
}

void CanvasPainter::ring(Vec2 centre, double radius, Colour colour, double width) {
    list_.AddCircle(im(camera_.toPixel(centre)), im(radius * scale_), colour, 0, im(width * scale_));
}

void CanvasPainter::handle(Vec2 centre, double radius, Colour fill, Colour border) {
    const Pixel middle = glm::round(camera_.toPixel(centre));
    const double r = std::round(radius * scale_);
    list_.AddRectFilled(im(middle - r), im(middle + r), fill, im(1.5 * scale_));
    list_.AddRect(im(middle - r), im(middle + r), border, im(1.5 * scale_), 0, im(1.25 * scale_));
}

void CanvasPainter::cross(Vec2 centre, double radius, Colour colour, double width) {
    const Pixel p = camera_.toPixel(centre);
    const double r = radius * scale_;
    list_.AddLine(im(p - r), im(p + r), colour, im(width * scale_));
    list_.AddLine(im(p + Pixel(-r, r)), im(p + Pixel(r, -r)), colour, im(width * scale_));
}

void CanvasPainter::tick(Vec2 centre, double radius, Colour colour, double width) {
    const Pixel p = camera_.toPixel(centre);
    const double r = radius * scale_;
    const ImVec2 points[] = {im(p + r * Pixel(-0.45, 0.05)), im(p + r * Pixel(-0.1, 0.4)),
                             im(p + r * Pixel(0.5, -0.35))};
    list_.AddPolyline(points, 3, colour, 0, im(width * scale_));
}

void CanvasPainter::circle(Vec2 centre, double radius, Colour colour, double width) {
    const double r = radius * camera_.zoom;
    if (r < kFar) {
        list_.AddCircle(im(camera_.toPixel(centre)), im(r), colour, 0, im(width * scale_));
    }
}

void CanvasPainter::disc(Vec2 centre, double radius, Colour fill) {
    list_.AddCircleFilled(im(camera_.toPixel(centre)), im(std::min(radius * camera_.zoom, kFar)), fill);
}

void CanvasPainter::dashedCircle(Vec2 centre, double radius, Colour colour, double width) {
    const double r = radius * camera_.zoom;
    if (r < 3.0 || r > kFar) {
        return;
    }
    const int dashes = std::clamp(static_cast<int>(2.0 * 3.14159265 * r / (12.0 * scale_)), 8, 400);
    const ImVec2 middle = im(camera_.toPixel(centre));
    for (int i = 0; i < dashes; ++i) {
        const double from = 2.0 * 3.14159265358979 * i / dashes;
        list_.PathArcTo(middle, im(r), im(from), im(from + 3.14159265358979 / dashes), 4);
        list_.PathStroke(colour, 0, im(width * scale_));
    }
}

namespace {

ImVec2 extentOf(ImFont &font, std::string_view text) {
    return font.CalcTextSizeA(imgui::lineOf(font), 1e9F, 0.0F, text.data(), text.data() + text.size());
}

constexpr double kLabelPadX = 5.0, kLabelPadY = 2.0; // design pixels

} // namespace

PixelRect CanvasPainter::labelRect(Vec2 at, Pixel offset, std::string_view text, ImFont *font) const {
    const ImVec2 size = extentOf(font != nullptr ? *font : *ImGui::GetFont(), text);
    const Pixel p = camera_.toPixel(at) + scale_ * offset;
    const double padX = kLabelPadX * scale_, padY = kLabelPadY * scale_;
    return {std::round(p.x) - padX, std::round(p.y) - padY, static_cast<double>(size.x) + 2.0 * padX,
            static_cast<double>(size.y) + 2.0 * padY};
}

void CanvasPainter::drawLabel(const PixelRect &rect, std::string_view text, Colour colour, Colour plate, ImFont *font,
                              bool free) {
    ImFont *used = font != nullptr ? font : ImGui::GetFont();
    aboveLines([&] {
        list_.AddRectFilled(im({rect.x, rect.y}), im({rect.x + rect.width, rect.y + rect.height}), plate,
                            im(4.0 * scale_));
        list_.AddText(used, imgui::lineOf(*used), im({rect.x + kLabelPadX * scale_, rect.y + kLabelPadY * scale_}),
                      colour, text.data(), text.data() + text.size());
    });
    space_.take(rect);
    placed_.push_back({rect, std::string(text), free});
}

PixelRect CanvasPainter::label(Vec2 at, Pixel offset, std::string_view text, Colour colour, Colour plate,
                               ImFont *font) {
    PixelRect rect = labelRect(at, offset, text, font);
    if (space_.holds(camera_.toPixel(at))) {
        const Pixel mirrored{-offset.x - rect.width / scale_ + 2.0 * kLabelPadX,
                             -offset.y - rect.height / scale_ + 2.0 * kLabelPadY};
        const double level = rect.height / scale_ + 2.0;
        rect = space_.inside(rect);
        std::vector<Pixel> offsets = {offset, {mirrored.x, offset.y}, {offset.x, mirrored.y}, mirrored};
        for (const double step : {1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0, -4.0}) {
            offsets.emplace_back(offset.x, offset.y + step * level);
            offsets.emplace_back(mirrored.x, offset.y + step * level);
        }
        for (const Pixel other : offsets) {
            const PixelRect there = labelRect(at, other, text, font);
            if (space_.isFree(there, false)) {
                rect = there;
                break;
            }
        }
    }
    drawLabel(rect, text, colour, plate, font, false);
    return rect;
}

void CanvasPainter::fixedLabel(Vec2 at, Pixel offset, std::string_view text, Colour colour, Colour plate,
                               ImFont *font) {
    drawLabel(labelRect(at, offset, text, font), text, colour, plate, font, true);
}

Pixel CanvasPainter::offsetOf(Vec2 at, const PixelRect &label) const {
    return (Pixel(label.x, label.y) - camera_.toPixel(at)) / scale_ + Pixel(kLabelPadX, kLabelPadY);
}

std::vector<Pixel> offsetsBeside(Pixel size, Pixel offset) {
    const double mirrored = -offset.x - size.x + 2.0 * kLabelPadX;
    std::vector<Pixel> offsets;
    for (const double level : {0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0}) {
        for (const double x : {offset.x, mirrored}) {
            offsets.emplace_back(x, offset.y + level * (size.y + 1.0));
        }
    }
    return offsets;
}

bool CanvasPainter::freeLabel(Vec2 at, Pixel offset, std::string_view text, Colour colour, Colour plate, ImFont *font) {
    return freeLabel(at, offsetsBeside(labelSize(text, font), offset), text, colour, plate, font);
}

bool CanvasPainter::freeLabel(Vec2 at, std::span<const Pixel> offsets, std::string_view text, Colour colour,
                              Colour plate, ImFont *font) {
    const std::optional<Pixel> offset = freeOffset(at, offsets, text, font);
    if (offset) {
        drawLabel(labelRect(at, *offset, text, font), text, colour, plate, font, true);
    }
    return offset.has_value();
}

std::optional<Pixel> CanvasPainter::freeOffset(Vec2 at, std::span<const Pixel> offsets, std::string_view text,
                                               ImFont *font) const {
    const auto free = std::find_if(offsets.begin(), offsets.end(), [&](Pixel offset) {
        return space_.isFree(labelRect(at, offset, text, font), true);
    });
    return free == offsets.end() ? std::nullopt : std::optional(*free);
}

Pixel CanvasPainter::labelSize(std::string_view text, ImFont *font) const {
    const PixelRect rect = labelRect({}, {}, text, font);
    return Pixel(rect.width, rect.height) / scale_;
}

void CanvasPainter::frame(const PixelRect &rect, Colour colour) {
    aboveLines([&] {
        list_.AddRect(im({rect.x, rect.y}), im({rect.x + rect.width, rect.y + rect.height}), colour, im(4.0 * scale_),
                      0, im(1.5 * scale_));
    });
}

namespace {

constexpr double kLineCell = 4.0; // design pixels; less than the gap between a line and the text beside it

} // namespace

void CanvasPainter::leader(Vec2 from, Colour colour) {
    const PixelRect &rect = placed_.back().rect;
    const Pixel begin = camera_.toPixel(from);
    const Pixel end = glm::clamp(begin, {rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height});
    list_.AddLine(im(begin), im(end), fade(colour, 0.7), im(scale_));
}

void CanvasPainter::keepInside(const PixelRect &room) {
    space_.open(room, kLineCell * scale_);
}

void CanvasPainter::reserve(const Outline &outline) {
    const double near = 0.25 * kLineCell * scale_; // shorter segments are taken together
    Pixel last{};
    std::vector<Vec2> points;
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        points.clear();
        if (outline.isCurved(k)) {
            addAlong(outline.curves[k], 1.0, points);
        } else {
            points.push_back(outline.to(k));
        }
        last = k == 0 ? camera_.toPixel(outline.from(k)) : last;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Pixel next = camera_.toPixel(points[i]);
            const bool end = k + 1 == outline.segmentCount() && i + 1 == points.size();
            if (end || std::max(std::abs(next.x - last.x), std::abs(next.y - last.y)) >= near) {
                space_.takeLine(last, next);
                last = next;
            }
        }
    }
}

void CanvasPainter::reserve(Vec2 place, double radius) {
    const Pixel p = camera_.toPixel(place);
    const double half = radius * scale_;
    reserve(PixelRect{p.x - half, p.y - half, 2.0 * half, 2.0 * half});
}

void CanvasPainter::text(Vec2 at, std::string_view text, Colour colour, ImFont *font) {
    ImFont *used = font != nullptr ? font : ImGui::GetFont();
    const ImVec2 size = used->CalcTextSizeA(imgui::lineOf(*used), 1e9F, 0.0F, text.data(), text.data() + text.size());
    const Pixel p = camera_.toPixel(at);
    list_.AddText(used, imgui::lineOf(*used), im({std::round(p.x - 0.5 * size.x), std::round(p.y - 0.5 * size.y)}),
                  colour, text.data(), text.data() + text.size());
}

} // namespace forefront
