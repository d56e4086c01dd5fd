#include "core/drawing/colour_outline/outline_fit.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "core/engine/geometry/polygon.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <stop_token>
#include <vector>

using namespace forefront;

namespace lake_picture {

using Colour = std::array<std::uint8_t, 3>;
constexpr Colour kWater{70, 110, 190}, kLand{120, 150, 70}, kSand{215, 200, 150};

/// A picture that is painted pixel by pixel from a function of the place in pixels from the lower left corner.
struct Painted {
    int columns = 0, rows = 0;
    std::vector<std::uint8_t> rgba;

    PixelView view() const { return {rgba, columns, rows}; }
    PixelPlace at(Vec2 place) const { return {static_cast<int>(place.x), rows - 1 - static_cast<int>(place.y)}; }
};

Painted paint(int columns, int rows, const std::function<Colour(Vec2)> &colourAt) {
    Painted result{columns, rows, {}};
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            for (const std::uint8_t channel : colourAt({column + 0.5, rows - row - 0.5})) {
                result.rgba.push_back(channel);
            }
            result.rgba.push_back(255);
        }
    }
    return result;
}

/// The shore of a made-up lake: its distance from the middle in a direction.
double shoreAt(double angle) {
    return 150.0 + 25.0 * std::sin(3.0 * angle) + 12.0 * std::cos(5.0 * angle + 1.0);
}

constexpr Vec2 kMiddle{200.0, 205.0}, kIsland{230.0, 190.0};
constexpr double kIslandRadius = 32.0;

/// The lake with an island and a boat of a few pixels; `grain` shifts the colours of neighbouring pixels.
Painted lake(int grain = 0) {
    return paint(400, 400, [grain](Vec2 at) {
        const Vec2 arm = at - kMiddle;
        const bool wet = length(arm) < shoreAt(std::atan2(arm.y, arm.x)) && distance(at, kIsland) > kIslandRadius;
        const bool boat = distance(at, {150.0, 200.0}) < 2.5;
        Colour colour = boat ? kSand : wet ? kWater : kLand;
        const int noise = static_cast<int>(std::fmod(at.x * 7.0 + at.y * 13.0, 2.0 * grain + 1.0)) - grain;
        for (std::uint8_t &channel : colour) {
            channel = static_cast<std::uint8_t>(channel + noise);
        }
        return colour;
    });
}

double areaOfLake() {
    double sum = 0.0; // the integral of r²/2; the trapezoidal rule is exact for so few harmonics
    constexpr int kSteps = 720;
    for (int k = 0; k < kSteps; ++k) {
        const double r = shoreAt(2.0 * std::numbers::pi * k / kSteps);
        sum += 0.5 * r * r * 2.0 * std::numbers::pi / kSteps;
    }
    return sum;
}

double areaOf(const std::vector<Curve> &loop) {
    CompensatedSum sum;
    for (const Curve &curve : loop) {
        sum.add(sectorArea(curve, {}) + 0.0);
    }
    return sum.value();
}

OutlineFit outlineOf(const Painted &picture, Vec2 seed, double tolerance, double smoothness) {
    return fitOutlines(outlinesOf(floodByColour(picture.view(), picture.at(seed), tolerance)), smoothness);
}

} // namespace lake_picture

using namespace lake_picture;

TEST_CASE("Colour outline: the shore of a lake and its island within 0.5 % of their areas, with few nodes") {
    for (const int grain : {0, 4}) {
        CAPTURE(grain);
        const Painted picture = lake(grain);
        const OutlineFit fit = outlineOf(picture, {120.0, 200.0}, 12.0, 2.0);
        REQUIRE(fit.loops.size() == 2);
        CHECK(fit.dropped == 1); // the boat
        CHECK(areaOf(fit.loops[0]) == doctest::Approx(areaOfLake()).epsilon(0.005));
        CHECK(-areaOf(fit.loops[1]) == doctest::Approx(std::numbers::pi * kIslandRadius * kIslandRadius).epsilon(0.01));
        CHECK(fit.loops[0].size() <= 24);
        CHECK(fit.loops[1].size() <= 8);
        for (const Curve &curve : fit.loops[0]) {
            for (double t = 0.0; t < 1.0; t += 0.1) {
                const Vec2 arm = curve.point(t) - kMiddle;
                CHECK(std::fabs(length(arm) - shoreAt(std::atan2(arm.y, arm.x))) < 3.5);
            }
        }
    }
}

TEST_CASE("Colour outline: more smoothness gives fewer nodes, more tolerance a larger region") {
    const Painted picture = lake();
    const std::vector<PixelLoop> outlines = outlinesOf(floodByColour(picture.view(), {120, 200}, 12.0));
    const std::size_t fine = fitOutlines(outlines, 1.0).nodes(), coarse = fitOutlines(outlines, 6.0).nodes();
    CHECK(coarse < fine);
    const ColourRegion all = floodByColour(picture.view(), {120, 200}, 150.0);
    CHECK(all.count == 400U * 400U);
    const std::vector<PixelLoop> frame = outlinesOf(all);
    REQUIRE(frame.size() == 1);
    CHECK(signedArea(frame[0]) == doctest::Approx(160000.0 - 0.5)); // corners are cut by half a pixel
    CHECK(fitOutlines(frame, 2.0).loops[0].size() == 4);
}

TEST_CASE("Colour outline: the shapes are a domain with a hole, in the plane, in one command") {
    const OutlineFit fit = outlineOf(lake(), {120.0, 200.0}, 12.0, 2.0);
    const PlaneMap map{{0.0, 3.0}, {-3.0, 0.0}, {1000.0, 500.0}};
    const Result<Document> next = addShapes(Document{}, boundariesAlong(fit, map));
    REQUIRE(next);
    REQUIRE(next->shapes.size() == 2);
    CHECK(validate(toDomain(*next)).empty());
}

TEST_CASE("Colour outline: outlines in a narrow channel follow the pixels more closely, so that they do not cross") {
    // Two ponds that almost touch an island between them, and a channel of a single pixel along a diagonal.
    const Painted picture = paint(120, 120, [](Vec2 at) {
        const bool pond = distance(at, {60.0, 60.0}) < 50.0;
        const bool island = distance(at, {71.0, 60.0}) < 37.6;
        return pond && !island ? kWater : kLand;
    });
    const std::vector<PixelLoop> outlines = outlinesOf(floodByColour(picture.view(), picture.at({15.0, 60.0}), 12.0));
    REQUIRE(outlines.size() == 2);
    const OutlineFit fit = fitOutlines(outlines, 5.0);
    REQUIRE(fit.loops.size() == 2);
    const Result<Document> next = addShapes(Document{}, boundariesAlong(fit, PlaneMap{}));
    REQUIRE(next);
    CHECK(validate(toDomain(*next)).empty());
}

TEST_CASE("Colour outline: regions that meet at a corner alone are apart, and holes are connected there") {
    const std::vector<int> squares{1, 1, 0, 0, //
                                   1, 0, 1, 0, //
                                   0, 1, 1, 0, //
                                   0, 0, 0, 1};
    const Painted picture = paint(4, 4, [&](Vec2 at) {
        const auto k = static_cast<std::size_t>(4 * (3 - static_cast<int>(at.y)) + static_cast<int>(at.x));
        return squares[k] != 0 ? kWater : kLand;
    });
    const ColourRegion corner = floodByColour(picture.view(), {0, 0}, 10.0);
    CHECK(corner.count == 3);
    CHECK(outlinesOf(corner).size() == 1);
    const ColourRegion land = floodByColour(picture.view(), {3, 0}, 10.0);
    CHECK(land.count == 4); // the land in the middle and at the lower left is reached by corners alone
    CHECK(outlinesOf(land).size() == 1);
}

TEST_CASE("Colour outline: a single pixel and a region that was cancelled") {
    const Painted picture = paint(5, 5, [](Vec2 at) { return distance(at, {2.5, 2.5}) < 0.4 ? kWater : kLand; });
    const OutlineFit fit = outlineOf(picture, {2.5, 2.5}, 5.0, 2.0);
    REQUIRE(fit.loops.size() == 1);
    CHECK(addShapes(Document{}, boundariesAlong(fit, PlaneMap{})));
    std::stop_source source;
    source.request_stop();
    const Progress stopped{{}, source.get_token()};
    CHECK(floodByColour(picture.view(), {2, 2}, 5.0, stopped).inside.empty());
    CHECK(outlinesOf(ColourRegion{}, stopped).empty());
}

TEST_CASE("Colour outline: a transparent pixel looks white") {
    Painted picture = paint(3, 1, [](Vec2) { return Colour{0, 0, 0}; });
    picture.rgba[3] = 0;
    picture.rgba[4] = picture.rgba[5] = picture.rgba[6] = 255;
    CHECK(floodByColour(picture.view(), {0, 0}, 1.0).count == 2);
}
