#include "app/window/icon.hpp"

#include "core/engine/base/vec2.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace forefront {

namespace {

struct Shade {
    double r = 0.0, g = 0.0, b = 0.0, a = 0.0;
};

void paint(Shade &pixel, std::uint32_t hex, double cover) {
    cover = std::clamp(cover, 0.0, 1.0);
    const auto channel = [hex](unsigned shift) { return static_cast<double>((hex >> shift) & 0xffU); };
    pixel.r += cover * (channel(16) - pixel.r);
    pixel.g += cover * (channel(8) - pixel.g);
    pixel.b += cover * (channel(0) - pixel.b);
    pixel.a += cover * (1.0 - pixel.a);
}

double distanceTo(Vec2 p, Vec2 a, Vec2 b) {
    const double t = std::clamp(dot(p - a, b - a) / lengthSquared(b - a), 0.0, 1.0);
    return distance(p, lerp(a, b, t));
}

/// Returns the signed distance into a counter-clockwise triangle, positive inside.
double inside(Vec2 p, Vec2 a, Vec2 b, Vec2 c) {
    const auto depth = [p](Vec2 u, Vec2 v) { return cross(v - u, p - u) / length(v - u); };
    return std::min({depth(a, b), depth(b, c), depth(c, a)});
}

/// Returns the distance into a square with rounded corners that fills [0, 64]².
double insideTile(Vec2 p) {
    constexpr double kRadius = 13.0;
    const Vec2 q{std::abs(p.x - 32.0) - (32.0 - kRadius), std::abs(p.y - 32.0) - (32.0 - kRadius)};
    return kRadius - length({std::max(q.x, 0.0), std::max(q.y, 0.0)}) - std::min(std::max(q.x, q.y), 0.0);
}

Shade pixelAt(Vec2 p, double unit) {
    // y up, in a tile of 64 units.
    constexpr Vec2 a{9, 13}, b{32, 11}, c{55, 13}, d{20, 33}, e{44, 33}, f{32, 53};
    struct Face {
        Vec2 a, b, c;
        std::uint32_t colour;
    };
    constexpr std::array<Face, 3> faces{{{a, b, d, 0x3cbb75}, {b, e, d, 0x238a8d}, {b, c, e, 0x404788}}};
    constexpr std::array<std::array<Vec2, 2>, 4> front{{{c, e}, {e, d}, {d, a}, {a, d}}};
    const auto cover = [unit](double depth) { return depth / unit + 0.5; };
    Shade pixel;
    paint(pixel, 0x1b212b, cover(insideTile(p)));
    for (const Face &face : faces) {
        paint(pixel, face.colour, cover(inside(p, face.a, face.b, face.c)));
    }
    for (const Face &face : faces) {
        const double edge =
            std::min({distanceTo(p, face.a, face.b), distanceTo(p, face.b, face.c), distanceTo(p, face.c, face.a)});
        paint(pixel, 0x1b212b, cover(1.1 - edge));
    }
    paint(pixel, 0x7d8899, cover(1.2 - std::min(distanceTo(p, d, f), distanceTo(p, f, e))));
    for (const auto &segment : front) {
        paint(pixel, 0xff9a3d, cover(2.3 - distanceTo(p, segment[0], segment[1])));
    }
    paint(pixel, 0xff9a3d, cover(4.3 - distance(p, f)));
    return pixel;
}

} // namespace

std::vector<std::uint8_t> makeIcon(int size) {
    std::vector<std::uint8_t> rgba;
    rgba.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * 4);
    const double unit = 64.0 / size;
    for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
            const Shade pixel = pixelAt({(column + 0.5) * unit, 64.0 - (row + 0.5) * unit}, unit);
            for (const double channel : {pixel.r, pixel.g, pixel.b, 255.0 * pixel.a}) {
                rgba.push_back(static_cast<std::uint8_t>(std::clamp(channel + 0.5, 0.0, 255.0)));
            }
        }
    }
    return rgba;
}

} // namespace forefront
