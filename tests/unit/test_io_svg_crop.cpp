#include "core/geometry/polygon.hpp"
#include "core/io/svg/svg_crop.hpp"
#include "tests/support/random_domains.hpp"

#include <doctest/doctest.h>

#include <cmath>

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

TEST_CASE("SVG crop: random paths wind around places in the box as before, and stay near it") {
    constexpr double kTolerance = 1e-6;
    RandomSource random(17);
    int compared = 0, wound = 0;
    for (int run = 0; run < 1000; ++run) {
        CAPTURE(run);
        const double reach = std::pow(10.0, random.between(0.0, 6.0));
        const SvgPath whole = randomPath(random, reach);
        SvgPath cropped = whole;
        crop(cropped, kBox, kTolerance);
        REQUIRE(cropped.stretches.size() + 1 >= cropped.nodes.size());
        for (const Vec2 p : cropped.nodes) {
            CHECK(kBox.grown(1.0001 * kBox.diagonal()).contains(p));
        }
        for (std::size_t k = 0; k < cropped.nodes.size() && !cropped.stretches.empty(); ++k) {
            const CurveStretch stretch = k < cropped.stretches.size() ? cropped.stretches[k] : CurveStretch{};
            if (stretch.follows()) {
                const Curve &curve = cropped.curves[stretch.curve];
                CHECK(distance(curve.point(stretch.t0), cropped.nodes[k]) <= 1e-9 * reach);
                CHECK(distance(curve.point(stretch.t1), cropped.nodes[k + 1]) <= 1e-9 * reach);
            }
        }
        const std::vector<Vec2> before = polyline(whole, kTolerance);
        const std::vector<Vec2> after = cropped.nodes.empty() ? before : polyline(cropped, kTolerance);
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

TEST_CASE("SVG crop: a path inside the box stays, and of one beside it nothing is left to wind around") {
    SvgPath inside;
    inside.closed = true;
    inside.nodes = {{0.1, 0.1}, {0.9, 0.1}, {0.5, 0.9}};
    inside.stretches.resize(2);
    SvgPath same = inside;
    crop(same, kBox, 1e-6);
    CHECK(same.nodes == inside.nodes);
    SvgPath beside = inside;
    for (Vec2 &p : beside.nodes) {
        p.x += 1e9;
    }
    crop(beside, kBox, 1e-6);
    CHECK(beside.nodes.size() <= 3);
    for (const Vec2 p : beside.nodes) {
        CHECK(p.x == kBox.max.x);
    }
}

TEST_CASE("SVG crop: an open filled path is closed before it is cropped; a line of two nodes does not become an area") {
    SvgPath open;
    open.paint.filled = true;
    open.nodes = {{-1e6, 0.2}, {1e6, 0.2}, {1e6, 0.8}, {-1e6, 0.8}};
    open.stretches.resize(3);
    crop(open, kBox, 1e-6);
    CHECK(winding(open.nodes, {0.5, 0.5}, 0.0).first == 1);
    CHECK(winding(open.nodes, {0.5, 0.9}, 0.0).first == 0);
    SvgPath line;
    line.paint.filled = true;
    line.nodes = {{0.5, 0.5}, {1e6, 3e6}};
    line.stretches.resize(1);
    REQUIRE_FALSE(line.painted());
    crop(line, kBox, 1e-6);
    CHECK_FALSE(line.painted());
    CHECK(line.nodes.front() == Vec2{0.5, 0.5});
}
