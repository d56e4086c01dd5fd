#include "core/engine/geometry/predicates.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <random>
#include <vector>

using namespace forefront;

namespace {

using Rational = boost::multiprecision::cpp_rational;

Rational crossOf(const Rational &ax, const Rational &ay, const Rational &bx, const Rational &by) {
    return ax * by - ay * bx;
}

int signOf(const Rational &value) {
    return value.sign();
}

int rationalOrientation(Vec2 a, Vec2 b, Vec2 c) {
    const Rational cx(c.x), cy(c.y);
    return signOf(crossOf(Rational(a.x) - cx, Rational(a.y) - cy, Rational(b.x) - cx, Rational(b.y) - cy));
}

int rationalInCircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const Rational dx(d.x), dy(d.y);
    const Rational ax = Rational(a.x) - dx, ay = Rational(a.y) - dy;
    const Rational bx = Rational(b.x) - dx, by = Rational(b.y) - dy;
    const Rational cx = Rational(c.x) - dx, cy = Rational(c.y) - dy;
    return signOf((ax * ax + ay * ay) * crossOf(bx, by, cx, cy) + (bx * bx + by * by) * crossOf(cx, cy, ax, ay) +
                  (cx * cx + cy * cy) * crossOf(ax, ay, bx, by));
}

/// Returns how segments meet, from the parameters of their common points in rational arithmetic.
SegmentMeeting rationalMeeting(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const Rational ax(a.x), ay(a.y), ux = Rational(b.x) - ax, uy = Rational(b.y) - ay;
    const Rational cx(c.x), cy(c.y), vx = Rational(d.x) - cx, vy = Rational(d.y) - cy;
    const Rational wx = cx - ax, wy = cy - ay;
    const Rational determinant = crossOf(ux, uy, vx, vy);
    if (determinant == 0) {
        if (crossOf(ux, uy, wx, wy) != 0) {
            return SegmentMeeting::Apart;
        }
        const Rational square = ux * ux + uy * uy;
        const Rational s = (wx * ux + wy * uy) / square;
        const Rational t = ((wx + vx) * ux + (wy + vy) * uy) / square;
        const Rational low = std::max(Rational(0), std::min(s, t)), high = std::min(Rational(1), std::max(s, t));
        return low > high   ? SegmentMeeting::Apart
               : low < high ? SegmentMeeting::Overlapping
                            : SegmentMeeting::SharedEnd;
    }
    const Rational s = crossOf(wx, wy, vx, vy) / determinant, t = crossOf(wx, wy, ux, uy) / determinant;
    if (s < 0 || s > 1 || t < 0 || t > 1) {
        return SegmentMeeting::Apart;
    }
    const bool endOfFirst = s == 0 || s == 1, endOfSecond = t == 0 || t == 1;
    return endOfFirst && endOfSecond   ? SegmentMeeting::SharedEnd
           : endOfFirst || endOfSecond ? SegmentMeeting::Touching
                                       : SegmentMeeting::Crossing;
}

/// Kinds of numbers that break careless predicates.
class NumberSource {
  public:
    explicit NumberSource(std::uint64_t seed) : random_(seed) {}

    double anyFinite() {
        for (;;) {
            const double value = std::bit_cast<double>(random_());
            if (std::isfinite(value)) {
                return value;
            }
        }
    }
    double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
    int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
    /// A value moved by a few units in the last place.
    double nudged(double value) {
        for (int step = integer(-3, 3); step != 0; step += step > 0 ? -1 : 1) {
            value = std::nextafter(value, step > 0 ? HUGE_VAL : -HUGE_VAL);
        }
        return value;
    }
    double extreme() {
        switch (integer(0, 5)) {
        case 0:
            return std::ldexp(unit() - 0.5, integer(-1080, -1000));
        case 1:
            return std::ldexp(unit() - 0.5, integer(1000, 1024));
        case 2:
            return 0.0;
        case 3:
            return integer(-2, 2) * std::numeric_limits<double>::denorm_min();
        case 4:
            return integer(0, 1) == 0 ? std::numeric_limits<double>::max() : -std::numeric_limits<double>::max();
        default:
            return integer(-3, 3);
        }
    }

    /// Numbers near the minimum and maximum for which expansions are used.
    double edge() {
        constexpr int kExponents[] = {-400, 480, -200, 240, 0};
        const double value = std::ldexp(nudged(1.0), kExponents[integer(0, 4)] + integer(-1, 1));
        return integer(0, 1) == 0 ? value : -value;
    }

    /// Four points of the given kind; in most kinds at least three are nearly collinear or all nearly cocircular.
    std::vector<Vec2> points(int kind) {
        std::vector<Vec2> p(4);
        const double scale = std::ldexp(1.0, integer(-260, 240)), offset = integer(0, 1) * std::ldexp(1.0, 30);
        const Vec2 origin{unit() + offset, unit() - offset}, step{unit() - 0.5, unit() - 0.5};
        const double angle0 = 6.3 * unit();
        for (Vec2 &q : p) {
            const double t = integer(-8, 8) / 4.0, angle = angle0 + 6.3 * unit();
            switch (kind) {
            case 0:
                q = {anyFinite(), anyFinite()};
                break;
            case 1:
                q = {extreme(), extreme()};
                break;
            case 2: // a small lattice: exact degeneracy is common
                q = {1.0 * integer(-3, 3), 1.0 * integer(-3, 3)};
                break;
            case 3: // on a line but for rounding
                q = {nudged(origin.x + t * step.x), nudged(origin.y + t * step.y)};
                break;
            case 4: // on a circle but for rounding
                q = {nudged(origin.x + std::cos(angle)), nudged(origin.y + std::sin(angle))};
                break;
            case 5: // on a line through the origin, at distances of all magnitudes
                q = std::ldexp(1.0, integer(-300, 300)) * Vec2{nudged(step.x), nudged(step.y)};
                break;
            case 6: // where the evaluation changes from expansions to integers
                q = {edge(), edge()};
                break;
            case 7: // a line at any scale
                q = {scale * nudged(t * step.x), scale * nudged(t * step.y)};
                break;
            default: // a lattice at any scale
                q = {scale * integer(-2, 2), scale * integer(-2, 2)};
                break;
            }
        }
        return p;
    }

  private:
    std::mt19937_64 random_;
};

constexpr int kKinds = 9;
/// Lattices, where exact zeros must be common.
constexpr bool isLattice(int kind) {
    return kind == 2 || kind == 8;
}
/// Rational numbers of a thousand digits are slow.
constexpr int rounds(int kind, int limit) {
    return kind == 0 || kind == 1 || kind == 5 || kind == 6 ? limit / 6 : limit;
}

} // namespace

TEST_CASE("predicates: orientation agrees with rational arithmetic for every kind of doubles") {
    NumberSource source(11);
    for (int kind = 0; kind < kKinds; ++kind) {
        int zeros = 0;
        for (int round = 0; round < rounds(kind, 3000); ++round) {
            const auto p = source.points(kind);
            const int expected = rationalOrientation(p[0], p[1], p[2]);
            zeros += expected == 0 ? 1 : 0;
            REQUIRE(orientation(p[0], p[1], p[2]) == expected);
            REQUIRE(orientation(p[1], p[0], p[2]) == -expected);
            REQUIRE(orientation(p[2], p[0], p[1]) == expected);
        }
        if (isLattice(kind)) {
            CHECK(zeros > 100);
        }
    }
}

TEST_CASE("predicates: inCircle agrees with rational arithmetic for every kind of doubles") {
    NumberSource source(12);
    for (int kind = 0; kind < kKinds; ++kind) {
        int zeros = 0;
        for (int round = 0; round < rounds(kind, 1000); ++round) {
            const auto p = source.points(kind);
            const int expected = rationalInCircle(p[0], p[1], p[2], p[3]);
            zeros += expected == 0 ? 1 : 0;
            REQUIRE(inCircle(p[0], p[1], p[2], p[3]) == expected);
            REQUIRE(inCircle(p[1], p[0], p[2], p[3]) == -expected);
        }
        if (isLattice(kind)) {
            CHECK(zeros > 100);
        }
    }
}

TEST_CASE("predicates: inCircle tells inside from outside of a counter-clockwise circle") {
    CHECK(inCircle({0, 0}, {1, 0}, {0, 1}, {0.5, 0.5}) == 1);
    CHECK(inCircle({0, 0}, {1, 0}, {0, 1}, {1, 1}) == 0);
    CHECK(inCircle({0, 0}, {1, 0}, {0, 1}, {1, std::nextafter(1.0, 2.0)}) == -1);
    CHECK(inCircle({0, 0}, {0, 1}, {1, 0}, {0.5, 0.5}) == -1);
}

TEST_CASE("predicates: two segments meet as rational arithmetic says") {
    NumberSource source(13);
    int seen[5] = {};
    for (int kind = 0; kind < kKinds; ++kind) {
        for (int round = 0; round < rounds(kind, 2000); ++round) {
            const auto p = source.points(kind);
            if (p[0] == p[1] || p[2] == p[3]) {
                continue;
            }
            const SegmentMeeting expected = rationalMeeting(p[0], p[1], p[2], p[3]);
            ++seen[static_cast<int>(expected)];
            REQUIRE(meet(p[0], p[1], p[2], p[3]) == expected);
            REQUIRE(meet(p[3], p[2], p[0], p[1]) == expected);
        }
    }
    for (const int count : seen) {
        CHECK(count > 20);
    }
}

TEST_CASE("predicates: a point lies on a closed segment only if it does so exactly") {
    CHECK(onSegment({0, 0}, {3, 3}, {1, 1}));
    CHECK(onSegment({0, 0}, {3, 3}, {3, 3}));
    CHECK_FALSE(onSegment({0, 0}, {3, 3}, {4, 4}));
    CHECK_FALSE(onSegment({0, 0}, {3, 3}, {1, std::nextafter(1.0, 2.0)}));
    CHECK(onSegment({1e300, 0}, {-1e300, 0}, {5e-324, 0}));
    CHECK_FALSE(onSegment({1e300, 0}, {-1e300, 0}, {0, 5e-324}));
}

TEST_CASE("predicates: a segment without length meets another where its point lies on it") {
    CHECK(meet({1, 1}, {1, 1}, {0, 0}, {2, 2}) == SegmentMeeting::Touching);
    CHECK(meet({1, 1}, {1, 1}, {1, 1}, {2, 2}) == SegmentMeeting::SharedEnd);
    CHECK(meet({1, 1}, {1, 1}, {0, 0}, {2, 3}) == SegmentMeeting::Apart);
}
