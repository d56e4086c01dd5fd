#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/vec2.hpp"

#include <array>
#include <cstdint>
#include <numbers>
#include <vector>

namespace FOREFRONT_API forefront {

enum class CurveKind : std::uint8_t {
    Line,
    Arc,  ///< of a circle or an ellipse
    Cubic ///< Bézier
};

/// A curve with the parameter t from 0 to 1. A value: copies are independent. Affine images are exact: an elliptical
/// arc remains an elliptical arc.
class Curve {
  public:
    /// A line from the origin to itself.
    Curve() = default;
    static Curve line(Vec2 start, Vec2 end);
    /// Returns the arc centre + cos θ·u + sin θ·v with θ from `startAngle` to `startAngle` + `sweep`, in radians. For a
    /// circle, u and v are perpendicular and equally long.
    static Curve arc(Vec2 centre, Vec2 u, Vec2 v, double startAngle = 0.0, double sweep = 2.0 * std::numbers::pi);
    /// Returns the circle around `centre` from `onCircle` to itself, counter-clockwise.
    static Curve circle(Vec2 centre, Vec2 onCircle);
    static Curve quadratic(Vec2 start, Vec2 control, Vec2 end);
    static Curve cubic(Vec2 start, Vec2 control1, Vec2 control2, Vec2 end);
    /// Creates the curve of a kind from its numbers(), for readers of files.
    static Curve fromNumbers(CurveKind kind, const std::array<double, 8> &numbers);

    CurveKind kind() const { return kind_; }
    /// Returns the start and end of a line; the centre, u, v, start angle and sweep of an arc; the four points of a
    /// cubic.
    std::array<double, 8> numbers() const;
    bool finite() const;

    Vec2 point(double t) const;
    /// Returns dC/dt.
    Vec2 derivative(double t) const;
    /// Returns d²C/dt².
    Vec2 secondDerivative(double t) const;
    /// Returns the unit vector in the direction of increasing t; at a cusp, the one after it; zero for a single point.
    Vec2 tangent(double t) const;

    /// Returns the length of the part between two parameters, to about 12 digits.
    double length(double t0 = 0.0, double t1 = 1.0) const;
    /// Returns the total change of direction along the part between two parameters, in radians; turns in both
    /// directions add up.
    double turning(double t0 = 0.0, double t1 = 1.0) const;
    /// Returns the smallest box that contains the part between two parameters.
    Box2 bounds(double t0 = 0.0, double t1 = 1.0) const;
    /// Returns the maximum distance of the part between two parameters from its chord; up to a few percent less if the
    /// part turns by more than a quarter turn, so that it may reach beyond the ends of its chord.
    double deviation(double t0 = 0.0, double t1 = 1.0) const;

    /// Returns the parameter between two where the curve is nearest to a point; a local minimum if the part between
    /// bends by more than a quarter turn in a sixteenth of the parameter.
    double nearest(Vec2 p, double t0 = 0.0, double t1 = 1.0) const;

    /// Returns the part from t0 to t1 with a parameter from 0 to 1; reversed if t1 < t0.
    Curve part(double t0, double t1) const;
    /// Returns the image under an affine map of the plane, a function of a Vec2.
    template <class Map>
    Curve mapped(const Map &map) const {
        const Vec2 zero = map(Vec2{});
        Curve image = *this;
        for (std::size_t k = 0; k < 4; ++k) {
            const bool place = kind_ != CurveKind::Arc || k == 0;
            image.p_[k] = place ? map(p_[k]) : k == 3 ? p_[k] : map(p_[k]) - zero;
        }
        return image;
    }

    /// Returns the parameters, from the first after t0 up to t1, of a polyline that deviates by at most `tolerance`
    /// (domain units, > 0) from the part between; at most kMaxPieces of them. A curve that is not finite gives t1
    /// alone.
    std::vector<double> flatten(double tolerance, double t0 = 0.0, double t1 = 1.0) const;
    /// Does the same for a view of a box: outside the box, the curve becomes a few pieces that do not enter it, however
    /// small the tolerance is.
    std::vector<double> flattenWithin(const Box2 &box, double tolerance, double t0 = 0.0, double t1 = 1.0) const;
    static constexpr std::size_t kMaxPieces = 10000;

    friend bool operator==(const Curve &, const Curve &) = default;

  private:
    double angle(double t) const { return p_[3].x + t * p_[3].y; }
    std::vector<double> turningPoints(Vec2 direction) const;
    bool isCircular() const;
    double nearestOnCircle(Vec2 p, double t0, double t1) const;
    bool hasOneNearest(Vec2 p, double t0, double t1) const;
    double stationary(Vec2 p, double low, double high) const;

    CurveKind kind_ = CurveKind::Line;
    std::array<Vec2, 4> p_{}; ///< as in numbers(); a line uses the first and the last
};

/// Marks a segment that follows no curve.
inline constexpr std::uint32_t kNoCurve = 0xffffffffU;

/// The part of a curve that a segment follows.
struct CurveStretch {
    std::uint32_t curve = kNoCurve; ///< index into the curves of the domain
    double t0 = 0.0;                ///< parameter at the start of the segment
    double t1 = 0.0;                ///< parameter at its end; may be less than t0

    bool follows() const { return curve != kNoCurve; }
    CurveStretch reversed() const { return {curve, t1, t0}; }
    friend bool operator==(const CurveStretch &, const CurveStretch &) = default;
};

} // namespace forefront
