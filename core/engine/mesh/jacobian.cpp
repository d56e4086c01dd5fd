#include "core/engine/mesh/jacobian.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace forefront {

namespace {

/// The Bernstein coefficients of a polynomial: of degree 2 over a triangle, corners first, then those of its edges; or
/// of degree 3 in both directions over a square, row by row.
class Bernstein {
  public:
    explicit Bernstein(bool square) : square_(square) {}

    std::size_t count() const { return square_ ? 16 : 6; }
    double &operator[](std::size_t k) { return values_[k]; }
    double operator[](std::size_t k) const { return values_[k]; }
    /// Returns the value at corner k, which is a coefficient.
    double corner(std::size_t k) const {
        constexpr std::array<std::size_t, 4> kSquare = {0, 3, 15, 12};
        return values_[square_ ? kSquare[k] : k];
    }
    std::size_t corners() const { return square_ ? 4 : 3; }

    /// Returns the coefficients over the four parts that the middles of the edges divide the domain into: those at the
    /// corners in order; of a triangle, then the one in the middle.
    std::array<Bernstein, 4> parts() const { return square_ ? partsOfSquare() : partsOfTriangle(); }

  private:
    std::array<Bernstein, 4> partsOfTriangle() const {
        const auto [c0, c1, c2, e01, e12, e20] =
            std::array{values_[0], values_[1], values_[2], values_[3], values_[4], values_[5]};
        const double m01 = 0.25 * (c0 + c1) + 0.5 * e01, m12 = 0.25 * (c1 + c2) + 0.5 * e12,
                     m20 = 0.25 * (c2 + c0) + 0.5 * e20;
        const double across0 = 0.25 * (c0 + e01 + e12 + e20), across1 = 0.25 * (c1 + e01 + e12 + e20),
                     across2 = 0.25 * (c2 + e01 + e12 + e20);
        std::array<Bernstein, 4> parts = {*this, *this, *this, *this};
        parts[0].values_ = {c0, m01, m20, 0.5 * (c0 + e01), across0, 0.5 * (c0 + e20)};
        parts[1].values_ = {m01, c1, m12, 0.5 * (c1 + e01), 0.5 * (c1 + e12), across1};
        parts[2].values_ = {m20, m12, c2, across2, 0.5 * (c2 + e12), 0.5 * (c2 + e20)};
        parts[3].values_ = {m01, m12, m20, across1, across2, across0};
        return parts;
    }

    /// Divides along one direction, in which coefficients lie `step` apart, by de Casteljau's algorithm.
    std::array<Bernstein, 2> halves(std::size_t step) const {
        std::array<Bernstein, 2> found = {*this, *this};
        for (std::size_t row = 0; row < 4; ++row) {
            const std::size_t first = row * (step == 1 ? 4 : 1);
            const double a = values_[first], b = values_[first + step], c = values_[first + 2 * step],
                         d = values_[first + 3 * step];
            const double ab = 0.5 * (a + b), bc = 0.5 * (b + c), cd = 0.5 * (c + d);
            const double abc = 0.5 * (ab + bc), bcd = 0.5 * (bc + cd), middle = 0.5 * (abc + bcd);
            const std::array<double, 4> low = {a, ab, abc, middle}, high = {middle, bcd, cd, d};
            for (std::size_t k = 0; k < 4; ++k) {
                found[0].values_[first + k * step] = low[k];
                found[1].values_[first + k * step] = high[k];
            }
        }
        return found;
    }
    std::array<Bernstein, 4> partsOfSquare() const {
        const std::array<Bernstein, 2> sides = halves(1);
        const std::array<Bernstein, 2> left = sides[0].halves(4), right = sides[1].halves(4);
        return {left[0], right[0], right[1], left[1]};
    }

    bool square_;
    std::array<double, 16> values_{};
};

/// A map from the reference element, as a Bézier patch of degree 2: the control points of a triangle are its corners,
/// then those of its edges; of a square, row by row.
class BezierPatch {
  public:
    explicit BezierPatch(const PlacedCell &cell) : square_(cell.traits().corners == 4) {
        const Vec2 origin = cell.nodes[0]; // differences from it are nearly exact
        std::array<Vec2, kMaxCellNodes> n;
        for (std::size_t k = 0; k < cell.traits().nodes; ++k) {
            n[k] = cell.nodes[k] - origin;
        }
        if (!square_) {
            points_ = {
                n[0], n[1], n[2], control(n[0], n[3], n[1]), control(n[1], n[4], n[2]), control(n[2], n[5], n[0])};
            return;
        }
        const Vec2 centre = cell.kind == CellKind::Quadrilateral9
                                ? n[8]
                                : 0.5 * (n[4] + n[5] + n[6] + n[7]) - 0.25 * (n[0] + n[1] + n[2] + n[3]);
        const Vec2 bottom = control(n[0], n[4], n[1]), right = control(n[1], n[5], n[2]),
                   top = control(n[3], n[6], n[2]), left = control(n[0], n[7], n[3]);
        const Vec2 middle = control(n[7], centre, n[5]); // of the curve through the centre, from left to right
        points_ = {n[0], bottom, n[1], left, control(bottom, middle, top), right, n[3], top, n[2]};
    }

    /// Returns the Jacobian determinant.
    Bernstein determinant() const { return square_ ? determinantOfSquare() : determinantOfTriangle(); }

    /// Returns the place of a point of the reference element, relative to the first corner.
    Vec2 at(Vec2 p) const {
        const auto &c = points_;
        if (!square_) {
            const double l = 1.0 - p.x - p.y;
            return l * l * c[0] + p.x * p.x * c[1] + p.y * p.y * c[2] +
                   2.0 * (l * p.x * c[3] + p.x * p.y * c[4] + p.y * l * c[5]);
        }
        const auto along = [&](std::size_t row) {
            return (1.0 - p.x) * (1.0 - p.x) * c[row] + 2.0 * p.x * (1.0 - p.x) * c[row + 1] + p.x * p.x * c[row + 2];
        };
        return (1.0 - p.y) * (1.0 - p.y) * along(0) + 2.0 * p.y * (1.0 - p.y) * along(3) + p.y * p.y * along(6);
    }

    /// Returns the derivatives in both directions at a point of the reference element.
    std::array<Vec2, 2> derivatives(Vec2 p) const {
        const auto &c = points_;
        if (!square_) {
            const double l = 1.0 - p.x - p.y;
            return {2.0 * (l * (c[3] - c[0]) + p.x * (c[1] - c[3]) + p.y * (c[4] - c[5])),
                    2.0 * (l * (c[5] - c[0]) + p.x * (c[4] - c[3]) + p.y * (c[2] - c[5]))};
        }
        const std::array<double, 3> bx = {(1.0 - p.x) * (1.0 - p.x), 2.0 * p.x * (1.0 - p.x), p.x * p.x};
        const std::array<double, 3> by = {(1.0 - p.y) * (1.0 - p.y), 2.0 * p.y * (1.0 - p.y), p.y * p.y};
        Vec2 alongX, alongY;
        for (std::size_t k = 0; k < 3; ++k) {
            alongX += 2.0 * by[k] * ((1.0 - p.x) * (c[3 * k + 1] - c[3 * k]) + p.x * (c[3 * k + 2] - c[3 * k + 1]));
            alongY += 2.0 * bx[k] * ((1.0 - p.y) * (c[3 + k] - c[k]) + p.y * (c[6 + k] - c[3 + k]));
        }
        return {alongX, alongY};
    }

  private:
    /// Returns the control point of a parabola through a middle node.
    static Vec2 control(Vec2 a, Vec2 middle, Vec2 b) { return 2.0 * middle - 0.5 * (a + b); }

    /// The derivatives are linear: u and v at the corners.
    Bernstein determinantOfTriangle() const {
        const auto &c = points_;
        const std::array<Vec2, 3> u = {2.0 * (c[3] - c[0]), 2.0 * (c[1] - c[3]), 2.0 * (c[4] - c[5])};
        const std::array<Vec2, 3> v = {2.0 * (c[5] - c[0]), 2.0 * (c[4] - c[3]), 2.0 * (c[2] - c[5])};
        Bernstein found(false);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            found[k] = cross(u[k], v[k]);
            found[3 + k] = 0.5 * (cross(u[k], v[next]) + cross(u[next], v[k]));
        }
        return found;
    }

    /// The derivatives are of degree 1 in their own direction and 2 in the other; the product of Bernstein polynomials
    /// of degrees 1 and 2 is one of degree 3.
    Bernstein determinantOfSquare() const {
        constexpr double kProduct[2][3] = {{1.0, 2.0 / 3.0, 1.0 / 3.0}, {1.0 / 3.0, 2.0 / 3.0, 1.0}};
        const auto &c = points_;
        Bernstein found(true);
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                const Vec2 u = 2.0 * (c[3 * j + i + 1] - c[3 * j + i]);
                for (std::size_t k = 0; k < 3; ++k) {
                    for (std::size_t l = 0; l < 2; ++l) {
                        const Vec2 v = 2.0 * (c[3 * (l + 1) + k] - c[3 * l + k]);
                        found[4 * (j + l) + i + k] += kProduct[i][k] * kProduct[l][j] * cross(u, v);
                    }
                }
            }
        }
        return found;
    }

    bool square_;
    std::array<Vec2, 9> points_;
};

/// Returns the determinant of an element with the same corners and straight edges.
Bernstein straightDeterminant(const PlacedCell &cell) {
    const auto &n = cell.nodes;
    Bernstein found(cell.traits().corners == 4);
    if (cell.traits().corners == 3) {
        for (std::size_t k = 0; k < found.count(); ++k) {
            found[k] = cross(n[1] - n[0], n[2] - n[0]);
        }
        return found;
    }
    std::array<double, 4> corner;
    for (std::size_t k = 0; k < 4; ++k) {
        corner[k] = cross(cell.cornerAfter(k) - n[k], cell.cornerBefore(k) - n[k]);
    }
    for (std::size_t j = 0; j < 4; ++j) { // bilinear, written with degree 3
        for (std::size_t i = 0; i < 4; ++i) {
            const double x = static_cast<double>(i) / 3.0, y = static_cast<double>(j) / 3.0;
            found[4 * j + i] =
                (1.0 - y) * ((1.0 - x) * corner[0] + x * corner[1]) + y * ((1.0 - x) * corner[3] + x * corner[2]);
        }
    }
    return found;
}

/// A part of the reference element, its corners, and a determinant and a positive scale of it there.
struct JacobianPart {
    Bernstein determinant, scale;
    std::array<Vec2, 4> corners;
    unsigned depth = 0;

    /// Bounds the ratio from below: where all coefficients of determinant - r·scale are not negative, it is at least r.
    double bound() const {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < determinant.count(); ++k) {
            least = std::min(least, determinant[k] / scale[k]);
        }
        return least;
    }
    std::array<JacobianPart, 4> divided() const {
        const std::array<Bernstein, 4> d = determinant.parts(), s = scale.parts();
        const std::array<Vec2, 4> &c = corners;
        std::array<std::array<Vec2, 4>, 4> places;
        if (determinant.corners() == 3) {
            const Vec2 m01 = midpoint(c[0], c[1]), m12 = midpoint(c[1], c[2]), m20 = midpoint(c[2], c[0]);
            places = {{{c[0], m01, m20, {}}, {m01, c[1], m12, {}}, {m20, m12, c[2], {}}, {m01, m12, m20, {}}}};
        } else {
            const Vec2 m01 = midpoint(c[0], c[1]), m12 = midpoint(c[1], c[2]), m23 = midpoint(c[2], c[3]),
                       m30 = midpoint(c[3], c[0]), centre = midpoint(m01, m23);
            places = {{{c[0], m01, centre, m30},
                       {m01, c[1], m12, centre},
                       {centre, m12, c[2], m23},
                       {m30, centre, m23, c[3]}}};
        }
        return {JacobianPart{d[0], s[0], places[0], depth + 1}, JacobianPart{d[1], s[1], places[1], depth + 1},
                JacobianPart{d[2], s[2], places[2], depth + 1}, JacobianPart{d[3], s[3], places[3], depth + 1}};
    }
};

struct LeastRatio {
    double ratio = std::numeric_limits<double>::infinity();
    Vec2 at; ///< in the reference element
};

/// Finds the minimum of determinant/scale over the reference element to within `tolerance`. Ends early where a value is
/// below `enough`; parts with a bound above `clear` are left out.
LeastRatio minimumOf(const Bernstein &determinant, const Bernstein &scale, double tolerance, double enough,
                     double clear) {
    constexpr unsigned kMaxDepth = 15; // the bound is off by a share that falls by 4 with each division
    const std::array<Vec2, 4> whole = determinant.corners() == 3
                                          ? std::array<Vec2, 4>{Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}, Vec2{}}
                                          : std::array<Vec2, 4>{Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}};
    LeastRatio least;
    std::vector<JacobianPart> open{{determinant, scale, whole}};
    while (!open.empty()) {
        const JacobianPart part = open.back();
        open.pop_back();
        for (std::size_t k = 0; k < part.determinant.corners(); ++k) {
            const double ratio = part.determinant.corner(k) / part.scale.corner(k);
            if (ratio < least.ratio) {
                least = {ratio, part.corners[k]};
            }
        }
        if (least.ratio <= enough) {
            break;
        }
        const double bound = part.bound();
        if (bound <= clear && bound < least.ratio - tolerance && part.depth < kMaxDepth) {
            const std::array<JacobianPart, 4> parts = part.divided();
            open.insert(open.end(), parts.begin(), parts.end());
        }
    }
    return least;
}

} // namespace

std::optional<Vec2> foldIn(const PlacedCell &cell) {
    const BezierPatch patch(cell);
    const Bernstein determinant = patch.determinant();
    double largest = 0.0;
    bool positive = true;
    for (std::size_t k = 0; k < determinant.count(); ++k) {
        largest = std::max(largest, std::abs(determinant[k]));
        positive = positive && determinant[k] > 0.0;
    }
    if (positive) {
        return {};
    }
    constexpr double kZero = 1e-9;
    Bernstein scale = determinant;
    for (std::size_t k = 0; k < scale.count(); ++k) {
        scale[k] = largest > 0.0 ? largest : 1.0;
    }
    const LeastRatio least = minimumOf(determinant, scale, 0.0, kZero, kZero);
    return least.ratio <= kZero ? std::optional(cell.nodes[0] + patch.at(least.at)) : std::nullopt;
}

double leastJacobianRatio(const PlacedCell &cell) {
    constexpr double kTolerance = 1e-6, kNever = -std::numeric_limits<double>::infinity();
    return minimumOf(BezierPatch(cell).determinant(), straightDeterminant(cell), kTolerance, kNever, -kNever).ratio;
}

double jacobianUniformity(const PlacedCell &cell) {
    constexpr double kTolerance = 1e-6, kNever = -std::numeric_limits<double>::infinity();
    Bernstein determinant = BezierPatch(cell).determinant();
    Bernstein scale = determinant;
    double largest = 0.0;
    for (std::size_t k = 0; k < scale.count(); ++k) {
        largest = std::max(largest, std::abs(determinant[k]));
    }
    for (std::size_t k = 0; k < scale.count(); ++k) {
        scale[k] = largest;
    }
    const double least = minimumOf(determinant, scale, kTolerance, kNever, -kNever).ratio;
    for (std::size_t k = 0; k < determinant.count(); ++k) {
        determinant[k] = -determinant[k];
    }
    return least / -minimumOf(determinant, scale, kTolerance, kNever, -kNever).ratio;
}

double straightUniformity(const PlacedCell &cell) {
    double least = std::numeric_limits<double>::infinity(), most = 0.0;
    for (std::size_t k = 0; k < cell.traits().corners; ++k) { // the determinant is bilinear, or constant
        const double value = cross(cell.cornerAfter(k) - cell.nodes[k], cell.cornerBefore(k) - cell.nodes[k]);
        least = std::min(least, value);
        most = std::max(most, std::abs(value));
    }
    return most > 0.0 ? least / most : 0.0;
}

double jacobianAt(const PlacedCell &cell, Vec2 reference) {
    const std::array<Vec2, 2> along = BezierPatch(cell).derivatives(reference);
    return cross(along[0], along[1]);
}

} // namespace forefront
