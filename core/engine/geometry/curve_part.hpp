#pragma once

#include "core/engine/geometry/curve.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace forefront {

/// Returns the curvature at a parameter, positive to the left; 0 where the derivative vanishes.
double curvatureOf(const Curve &curve, double t);

/// A part of a curve between two parameters, with bounds on where it lies and how it bends.
struct CurvePart {
    /// The order of the parameters does not matter.
    CurvePart(const Curve &of, double from, double to);

    std::span<const Vec2> hull() const { return {corners.data(), cornerCount}; }
    /// Returns the greatest extent of the corners along the chord or across it.
    double size() const;

    Curve curve;
    double t0 = 0.0;
    double t1 = 1.0; ///< at least t0
    Vec2 start;
    Vec2 end;
    Vec2 along{1.0, 0.0};          ///< unit vector from start to end
    std::array<Vec2, 4> corners{}; ///< their convex hull contains the part
    std::size_t cornerCount = 0;
    double turn = 0.0;    ///< maximum angle between the part and its chord, in radians; π if it has no chord
    double sagitta = 0.0; ///< maximum distance of the part from the line through its ends
    double noise = 0.0;   ///< rounding error of computed points
};

/// Returns true if the hulls of two parts are surely farther than `gap` apart.
bool apart(const CurvePart &first, const CurvePart &second, double gap);

/// A part of a curve that turns by less than a quarter turn from an axis, as a graph over that axis.
class CurveGraph {
  public:
    struct Value {
        double t = 0.0; ///< parameter
        double y = 0.0;
        double slope = 0.0;
        double bend = 0.0; ///< second derivative
    };

    /// `axis`: a unit vector. The part must outlive the graph.
    CurveGraph(const CurvePart &part, Vec2 origin, Vec2 axis);

    double low() const { return low_; }
    double high() const { return high_; }
    Value at(double x) const;

  private:
    double place(double t) const { return dot(axis_, part_->curve.point(t) - origin_); }

    const CurvePart *part_;
    Vec2 origin_;
    Vec2 axis_;
    bool forward_ = true; ///< x increases with the parameter
    double low_ = 0.0;
    double high_ = 0.0;
};

} // namespace forefront
