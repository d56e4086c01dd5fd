#pragma once

#include "core/engine/base/vec2.hpp"
#include "core/engine/geometry/curve.hpp"

#include <string>
#include <vector>

namespace forefront {

/// A B-spline (NURBS) by its control points, or the points that it passes through.
struct DxfSpline {
    int degree = 3;
    bool closed = false;
    std::vector<double> knots;   ///< one more than the sum of degree and number of control points
    std::vector<double> weights; ///< of the control points, > 0; empty: all the same
    std::vector<Vec2> controls;
    std::vector<Vec2> fits;        ///< used if there are no control points
    Vec2 startTangent, endTangent; ///< of a spline through points; zero: free ends
};

/// The error of the cubics for rational splines and those of degree > 3, relative to the size of the spline.
inline constexpr double kDxfSplineError = 1e-8;

/// Appends the curves of a spline: exact lines and cubics up to degree 3 without weights, otherwise cubics. Points to
/// pass through give the cubic spline with continuous curvature and chord lengths as parameters. Returns why the data
/// are no spline; empty if they are one.
std::string appendSpline(const DxfSpline &spline, std::vector<Curve> &curves);

} // namespace forefront
