#include "tests/support/random_curves.hpp"

#include "core/drawing/arrangement/arrangement.hpp"
#include "tests/support/curve_drawing.hpp"
#include "tests/support/domain_builder.hpp"
#include "tests/support/random_domains.hpp"

#include <cmath>
#include <numbers>

namespace forefront::testing {

namespace {

using std::numbers::pi;

/// A drawing whose loops bound one domain by the even-odd rule.
class DomainDrawing {
  public:
    explicit DomainDrawing(double deviation, double weld = 0.0) : drawing_(deviation) {
        ArrangementInput &input = drawing_.input;
        input.tolerance = weld;
        contour_ = input.addContour(input.addShape(input.addFeature(1)), FillRule::EvenOdd);
    }

    void loop(const CurveLoop &curves, std::int32_t tag) { drawing_.loop(curves, contour_, tag); }
    void line(const CurveLoop &curves, std::int32_t tag) { drawing_.line(curves, tag); }
    void point(Vec2 at) { drawing_.point(at); }

    Domain domain() const {
        const auto arranged = arrange(drawing_.input);
        return arranged ? arranged->domain : Domain{};
    }

  private:
    CurveDrawing drawing_;
    std::uint32_t contour_ = 0;
};

/// Draws a smooth closed curve through points (Catmull-Rom tangents).
CurveLoop blobThrough(const std::vector<Vec2> &points) {
    CurveLoop loop;
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 before = points[(i + n - 1) % n], a = points[i], b = points[(i + 1) % n],
                   after = points[(i + 2) % n];
        loop.push_back(Curve::cubic(a, a + (1.0 / 6.0) * (b - before), b - (1.0 / 6.0) * (after - a), b));
    }
    return loop;
}

CurveLoop roundedPolygon(const std::vector<Vec2> &corners, double radius) {
    CurveLoop loop;
    const std::size_t n = corners.size();
    std::vector<Vec2> before(n), after(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 in = corners[(i + n - 1) % n] - corners[i], out = corners[(i + 1) % n] - corners[i];
        before[i] = corners[i] + std::min(radius / length(in), 0.4) * in;
        after[i] = corners[i] + std::min(radius / length(out), 0.4) * out;
    }
    for (std::size_t i = 0; i < n; ++i) {
        loop.push_back(Curve::quadratic(before[i], corners[i], after[i]));
        loop.push_back(Curve::line(after[i], before[(i + 1) % n]));
    }
    return loop;
}

void circles(DomainDrawing &drawing, RandomSource &random) {
    Vec2 centre{random.between(-1, 1), random.between(-1, 1)};
    double radius = random.between(0.5, 2.0);
    for (int depth = random.integer(1, 5); depth > 0; --depth) {
        drawing.loop({Curve::circle(centre, polar(centre, radius, random.between(0.0, 6.28)))}, depth);
        const double inner =
            radius * (random.chance(0.4) ? 1.0 - random.between(1e-3, 0.02) : random.between(0.1, 0.9));
        centre = polar(centre, 0.97 * random.unit() * (radius - inner), random.between(0.0, 6.28));
        radius = inner;
    }
}

void rounded(DomainDrawing &drawing, RandomSource &random) {
    const double radius = std::pow(10.0, random.between(-3.0, -0.3));
    drawing.loop(roundedPolygon(star(random, {0, 0}, 1.0, 0.6, 1.0, random.integer(3, 12)), radius), 1);
    if (random.chance(0.5)) {
        drawing.loop(roundedPolygon(star(random, {0, 0}, 0.2, 0.5, 1.0, random.integer(3, 8)), 0.5 * radius), 2);
    }
}

void blobs(DomainDrawing &drawing, RandomSource &random) {
    const std::vector<Vec2> points = star(random, {0, 0}, 1.0, random.between(0.3, 0.9), 1.0, random.integer(4, 20));
    drawing.loop(blobThrough(points), 1);
    const double scale = 1.0 - std::pow(10.0, random.between(-2.5, -0.3));
    std::vector<Vec2> inner;
    for (const Vec2 p : points) {
        inner.push_back(scale * p);
    }
    drawing.loop(blobThrough(inner), 2);
}

void ellipses(DomainDrawing &drawing, RandomSource &random) {
    for (int count = random.integer(1, 6); count > 0; --count) {
        const Vec2 centre{random.between(-1, 1), random.between(-1, 1)};
        const Vec2 u = polar({0, 0}, random.between(0.1, 1.0), random.between(0.0, 6.28));
        const Vec2 v = random.between(0.02, 1.0) * leftNormal(u) + random.between(-0.3, 0.3) * u;
        const double first = random.between(0.0, 6.28), half = random.chance(0.5) ? pi : -pi;
        drawing.loop({Curve::arc(centre, u, v, first, half), Curve::arc(centre, u, v, first + half, half)}, count);
    }
}

void crescents(DomainDrawing &drawing, RandomSource &random) {
    for (int count = random.integer(1, 4); count > 0; --count) {
        const Vec2 a{3.0 * count, random.between(-1, 1)}, b = a + Vec2{random.between(0.5, 2.0), random.between(-1, 1)};
        const Vec2 normal = leftNormal(b - a);
        const double outer = random.between(-1.5, 1.5), inner = outer + random.between(0.01, 0.4);
        const auto bulge = [&](double height) {
            return Curve::cubic(a, lerp(a, b, 0.2) + height * normal, lerp(a, b, 0.8) + height * normal, b);
        };
        drawing.loop({bulge(outer), bulge(inner).part(1.0, 0.0)}, count);
    }
}

void constraints(DomainDrawing &drawing, RandomSource &random) {
    drawing.loop({Curve::circle({0, 0}, {2, 0})}, 1);
    for (int count = random.integer(1, 4); count > 0; --count) {
        const auto inside = [&] { return polar({0, 0}, random.between(0.0, 1.5), random.between(0.0, 6.28)); };
        drawing.line({Curve::cubic(inside(), inside(), inside(), inside())}, 2);
    }
    for (int count = random.integer(0, 12); count > 0; --count) { // many close to the circle
        drawing.point(polar({0, 0}, 2.0 - std::pow(10.0, random.between(-2.5, 0.0)), random.between(0.0, 6.28)));
    }
}

void cusps(DomainDrawing &drawing, RandomSource &random) {
    for (int count = random.integer(1, 3); count > 0; --count) {
        const Vec2 a{random.between(-1, 1), random.between(-1, 1)}, b = a + Vec2{2, random.between(-0.2, 0.2)};
        const Vec2 high{0, random.between(0.5, 2.0)};
        CurveLoop loop;
        switch (random.integer(0, 2)) {
        case 0:
            loop = {Curve::cubic(a, b + high, a + high, b)}; // a cusp or a loop
            break;
        case 1:
            loop = {Curve::cubic(a, a, b + high, b)};
            break;
        default:
            loop = {Curve::cubic(a, a + high, b + high, b)};
            break;
        }
        loop.push_back(Curve::cubic(b, b, a - high, a));
        drawing.loop(loop, count);
    }
}

} // namespace

const char *nameOf(CurveFamily family) {
    constexpr const char *kNames[] = {"circles", "rounded", "blobs", "ellipses", "crescents", "constraints", "cusps"};
    return kNames[static_cast<int>(family)];
}

Domain curvedDomain(const std::vector<CurveLoop> &loops, double deviation, double weld) {
    DomainDrawing drawing(deviation, weld);
    for (const CurveLoop &loop : loops) {
        drawing.loop(loop, 1);
    }
    return drawing.domain();
}

Domain randomCurvedDomain(CurveFamily family, std::uint64_t seed) {
    RandomSource random(seed * kCurveFamilies + static_cast<std::uint64_t>(family));
    DomainDrawing drawing(std::pow(10.0, random.between(-4.0, -2.5)));
    switch (family) {
    case CurveFamily::Circles:
        circles(drawing, random);
        break;
    case CurveFamily::Rounded:
        rounded(drawing, random);
        break;
    case CurveFamily::Blobs:
        blobs(drawing, random);
        break;
    case CurveFamily::Ellipses:
        ellipses(drawing, random);
        break;
    case CurveFamily::Crescents:
        crescents(drawing, random);
        break;
    case CurveFamily::Constraints:
        constraints(drawing, random);
        break;
    case CurveFamily::Cusps:
        cusps(drawing, random);
        break;
    }
    return drawing.domain();
}

Domain randomCurvedDomain(std::uint64_t seed) {
    return randomCurvedDomain(static_cast<CurveFamily>(seed % kCurveFamilies), seed / kCurveFamilies);
}

} // namespace forefront::testing
