#include "core/drawing_files/svg/drawing/svg_crop.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "tests/support/random_domains.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>

using namespace forefront;
using testing::RandomSource;

namespace {

const Box2 kBox{{0.0, 0.0}, {1.0, 1.0}};

/// Returns a closed path of lines, cubics and arcs. `reach`: how far its nodes may be from the box.
SvgPath randomPath(RandomSource &random, double reach) {
    const auto place = [&] {
        const double far = random.chance(0.3) ? 0.2 : reach;
        return Vec2{random.between(-far, 1.0 + far), random.between(-far, 1.0 + far)};
    };
    SvgPath path;
    path.closed = true;
    path.paint.filled = true;
    path.nodes.push_back(place());
    for (int k = random.integer(2, 7); k > 0; --k) {
        const Vec2 from = path.nodes.back();
        Vec2 to = place();
        CurveStretch stretch;
        if (random.chance(0.6)) {
            Curve curve = Curve::cubic(from, place(), place(), to);
            if (random.chance(0.5)) {
                const Vec2 centre = place(), u = from - centre, v = place() - centre;
                curve = Curve::arc(centre, u, v, 0.0, random.between(-6.0, 6.0));
                to = curve.point(1.0);
            }
            stretch = {static_cast<std::uint32_t>(path.curves.size()), 0.0, 1.0};
            path.curves.push_back(curve);
        }
        path.nodes.push_back(to);
        path.stretches.push_back(stretch);
    }
    return path;
}

/// Returns the path as a closed polyline.
std::vector<Vec2> polyline(const SvgPath &path, double tolerance) {
    std::vector<Vec2> points{path.nodes.front()};
    for (std::size_t k = 0; k + 1 < path.nodes.size(); ++k) {
        const CurveStretch &stretch = path.stretches[k];
        if (stretch.follows()) {
            const Curve &curve = path.curves[stretch.curve];
            for (const double t : curve.flattenWithin(kBox, tolerance, stretch.t0, stretch.t1)) {
                points.push_back(curve.point(t));
            }
        }
        points.push_back(path.nodes[k + 1]);
    }
    return points;
}

/// Returns how often a closed polyline winds around a point, and whether it passes within `reach` of it.
std::pair<int, bool> winding(const std::vector<Vec2> &points, Vec2 p, double reach) {
    int turns = 0;
    bool near = false;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Vec2 a = points[k] - p, b = points[(k + 1) % points.size()] - p;
        const double side = cross(a, b);
        near = near || distanceToSegment(a, b, {}) <= reach;
        if ((a.y <= 0.0) != (b.y <= 0.0)) {
            turns += a.y <= 0.0 ? (side > 0.0 ? 1 : 0) : (side < 0.0 ? -1 : 0);
        }
    }
    return {turns, near};
}

} // namespace

TEST_CASE("SVG crop: random areas wind around places in the box as before, and stay near it") {
    constexpr double kTolerance = 1e-6;
    RandomSource random(17);
    int compared = 0, wound = 0;
    for (int run = 0; run < 1000; ++run) {
        CAPTURE(run);
        const double reach = std::pow(10.0, random.between(0.0, 6.0));
        const SvgPath whole = randomPath(random, reach);
        SvgPath cropped = whole;
        cropArea(cropped, kBox, kTolerance);
        REQUIRE(!cropped.nodes.empty());
        REQUIRE(cropped.stretches.size() + 1 == cropped.nodes.size());
        for (const Vec2 p : cropped.nodes) {
            CHECK(kBox.grown(1.0001 * kBox.diagonal()).contains(p));
        }
        for (std::size_t k = 0; k < cropped.stretches.size(); ++k) {
            const CurveStretch &stretch = cropped.stretches[k];
            if (stretch.follows()) {
                const Curve &curve = cropped.curves[stretch.curve];
                CHECK(distance(curve.point(stretch.t0), cropped.nodes[k]) <= 1e-9 * reach);
                CHECK(distance(curve.point(stretch.t1), cropped.nodes[k + 1]) <= 1e-9 * reach);
            }
        }
        const std::vector<Vec2> before = polyline(whole, kTolerance), after = polyline(cropped, kTolerance);
        for (int sample = 0; sample < 20; ++sample) {
            const Vec2 p{random.between(0.01, 0.99), random.between(0.01, 0.99)};
            const auto [expected, near] = winding(before, p, 4.0 * kTolerance);
            if (!near) {
                CHECK(winding(after, p, 0.0).first == expected);
                ++compared;
                wound += expected != 0 ? 1 : 0;
            }
        }
    }
    CHECK(compared > 15000);
    CHECK(wound > 5000);
}

TEST_CASE("SVG crop: random lines keep what lies in the box, and nothing else") {
    constexpr double kTolerance = 1e-6;
    const auto lengthWithin = [](const std::vector<Vec2> &points) {
        double sum = 0.0; // by samples, since the parts of curves may leave the box
        for (std::size_t k = 0; k + 1 < points.size(); ++k) {
            constexpr int kSamples = 400;
            for (int i = 0; i < kSamples; ++i) {
                const Vec2 p = lerp(points[k], points[k + 1], (i + 0.5) / kSamples);
                sum += kBox.contains(p) ? distance(points[k], points[k + 1]) / kSamples : 0.0;
            }
        }
        return sum;
    };
    RandomSource random(29);
    double total = 0.0;
    for (int run = 0; run < 500; ++run) {
        CAPTURE(run);
        SvgPath whole = randomPath(random, random.between(0.5, 5.0));
        whole.closed = false;
        double sum = 0.0;
        for (const SvgPath &line : croppedLines(whole, kBox, kTolerance)) {
            CHECK_FALSE(line.painted());
            CHECK_FALSE(line.closed);
            REQUIRE(line.stretches.size() + 1 == line.nodes.size());
            for (const Vec2 p : line.nodes) {
                CHECK(kBox.grown(1.0001 * kBox.diagonal()).contains(p));
            }
            sum += lengthWithin(polyline(line, kTolerance));
        }
        const double expected = lengthWithin(polyline(whole, kTolerance));
        CHECK(std::fabs(sum - expected) <= 0.02 * expected + 0.1);
        total += expected;
    }
    CHECK(total > 500.0);
}

TEST_CASE("SVG crop: of an area beside the box nothing is left") {
    SvgPath beside;
    beside.closed = true;
    beside.nodes = {{1e9, 0.1}, {2e9, 0.1}, {1e9, 0.9}};
    beside.stretches.resize(2);
    CHECK(croppedLines(beside, kBox, 1e-6).empty());
    cropArea(beside, kBox, 1e-6);
    CHECK(beside.nodes.size() < 3);
}

TEST_CASE("SVG crop: lines are cut on the sides exactly, by the last node and the first if the path is closed") {
    SvgPath open;
    open.nodes = {{-1e12, 0.25}, {1e12, 0.25}, {1e12, 0.75}, {-1e12, 0.75}, {0.5, 0.5}};
    open.stretches.resize(4);
    const std::vector<SvgPath> lines = croppedLines(open, kBox, 1e-6);
    REQUIRE(lines.size() == 3);
    CHECK(lines[0].nodes == std::vector<Vec2>{{0.0, 0.25}, {1.0, 0.25}});
    CHECK(lines[1].nodes == std::vector<Vec2>{{1.0, 0.75}, {0.0, 0.75}});
    REQUIRE(lines[2].nodes.size() == 2);
    CHECK(lines[2].nodes[0].x == 0.0);
    CHECK(lines[2].nodes[0].y == doctest::Approx(0.5).epsilon(1e-12));
    CHECK(lines[2].nodes[1] == Vec2{0.5, 0.5});
    open.closed = true;
    CHECK(croppedLines(open, kBox, 1e-6).size() == 3); // the way back continues from the middle
}
