#include "core/engine/geometry/predicates.hpp"

#include "core/engine/geometry/big_integer.hpp"
#include "core/engine/geometry/expansion.hpp"

#include <initializer_list>

namespace forefront {

namespace {

/// Returns true if every coordinate is zero or has its magnitude in [low, high].
bool within(std::initializer_list<Vec2> points, double low, double high) {
    for (const Vec2 p : points) {
        for (const double value : {std::fabs(p.x), std::fabs(p.y)}) {
            if (value != 0.0 && (value < low || value > high)) {
                return false;
            }
        }
    }
    return true;
}

struct BigVec2 {
    BigInteger x, y;
    explicit BigVec2(Vec2 p) : x(BigInteger::fromScaledDouble(p.x)), y(BigInteger::fromScaledDouble(p.y)) {}
};

int orientationBig(Vec2 a, Vec2 b, Vec2 c) {
    const BigVec2 p(a), q(b), o(c);
    return ((p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x)).sign();
}

int inCircleBig(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const BigVec2 p(a), q(b), r(c), o(d);
    const BigInteger px = p.x - o.x, py = p.y - o.y, qx = q.x - o.x, qy = q.y - o.y, rx = r.x - o.x, ry = r.y - o.y;
    return ((px * px + py * py) * (qx * ry - qy * rx) + (qx * qx + qy * qy) * (rx * py - ry * px) +
            (rx * rx + ry * ry) * (px * qy - py * qx))
        .sign();
}

using Difference = Expansion<2>;

Expansion<16> crossExpansion(const Difference &ax, const Difference &ay, const Difference &bx, const Difference &by) {
    return sum(product(ax, by), negated(product(ay, bx)));
}

Expansion<16> squareExpansion(const Difference &x, const Difference &y) {
    return sum(product(x, x), product(y, y));
}

/// Range of coordinates for which differences, products of degree 4 and their errors stay normal.
constexpr double kMinDegree4 = 0x1p-200, kMaxDegree4 = 0x1p+240;

int inCircleExact(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    if (!within({a, b, c, d}, kMinDegree4, kMaxDegree4)) {
        return inCircleBig(a, b, c, d);
    }
    const Difference ax = difference(a.x, d.x), ay = difference(a.y, d.y);
    const Difference bx = difference(b.x, d.x), by = difference(b.y, d.y);
    const Difference cx = difference(c.x, d.x), cy = difference(c.y, d.y);
    const auto partA = product(squareExpansion(ax, ay), crossExpansion(bx, by, cx, cy));
    const auto partB = product(squareExpansion(bx, by), crossExpansion(cx, cy, ax, ay));
    const auto partC = product(squareExpansion(cx, cy), crossExpansion(ax, ay, bx, by));
    return sum(sum(partA, partB), partC).sign();
}

} // namespace

int orientationExact(Vec2 a, Vec2 b, Vec2 c) {
    // Products of such differences and their errors stay normal.
    if (!within({a, b, c}, 0x1p-400, 0x1p+480)) {
        return orientationBig(a, b, c);
    }
    return crossExpansion(difference(a.x, c.x), difference(a.y, c.y), difference(b.x, c.x), difference(b.y, c.y))
        .sign();
}

int inCircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    // Shewchuk's bound A. Where squares stay below 2^480, everything that underflows adds up to less than 2^-500;
    // larger or non-finite intermediate results go to the exact evaluation.
    constexpr double kHalfUlp = 0.5 * std::numeric_limits<double>::epsilon();
    constexpr double kRelative = (10.0 + 96.0 * kHalfUlp) * kHalfUlp;
    const Vec2 p = a - d, q = b - d, r = c - d;
    const double pp = lengthSquared(p), qq = lengthSquared(q), rr = lengthSquared(r);
    const double qr1 = q.x * r.y, qr2 = q.y * r.x, rp1 = r.x * p.y, rp2 = r.y * p.x, pq1 = p.x * q.y, pq2 = p.y * q.x;
    const double determinant = pp * (qr1 - qr2) + qq * (rp1 - rp2) + rr * (pq1 - pq2);
    const double permanent = pp * (std::fabs(qr1) + std::fabs(qr2)) + qq * (std::fabs(rp1) + std::fabs(rp2)) +
                             rr * (std::fabs(pq1) + std::fabs(pq2));
    const double bound = kRelative * permanent + 0x1p-500;
    if (pp + qq + rr < 0x1p+480) {
        if (determinant > bound) {
            return 1;
        }
        if (determinant < -bound) {
            return -1;
        }
    }
    return inCircleExact(a, b, c, d);
}

bool onSegment(Vec2 a, Vec2 b, Vec2 p) {
    return boxOf(a, b).contains(p) && orientation(a, b, p) == 0;
}

namespace {

/// Compares collinear segments as intervals of the coordinate in which ab (or cd) extends.
SegmentMeeting meetCollinear(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const bool alongX = a.x != b.x || c.x != d.x;
    const auto position = [alongX](Vec2 p) { return alongX ? p.x : p.y; };
    const double minimum = std::max(std::min(position(a), position(b)), std::min(position(c), position(d)));
    const double maximum = std::min(std::max(position(a), position(b)), std::max(position(c), position(d)));
    if (minimum > maximum) {
        return SegmentMeeting::Apart;
    }
    if (minimum < maximum) {
        return SegmentMeeting::Overlapping;
    }
    const bool endOfFirst = position(a) == minimum || position(b) == minimum;
    const bool endOfSecond = position(c) == minimum || position(d) == minimum;
    return endOfFirst && endOfSecond ? SegmentMeeting::SharedEnd : SegmentMeeting::Touching;
}

} // namespace

SegmentMeeting meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    if (!boxOf(a, b).overlaps(boxOf(c, d))) {
        return SegmentMeeting::Apart;
    }
    const int c1 = orientation(a, b, c), d1 = orientation(a, b, d);
    if (c1 * d1 > 0) {
        return SegmentMeeting::Apart;
    }
    const int a2 = orientation(c, d, a), b2 = orientation(c, d, b);
    if (a2 * b2 > 0) {
        return SegmentMeeting::Apart;
    }
    if (c1 == 0 && d1 == 0 && a2 == 0 && b2 == 0) {
        return meetCollinear(a, b, c, d);
    }
    if (c1 != 0 && d1 != 0 && a2 != 0 && b2 != 0) {
        return SegmentMeeting::Crossing;
    }
    return a == c || a == d || b == c || b == d ? SegmentMeeting::SharedEnd : SegmentMeeting::Touching;
}

} // namespace forefront
