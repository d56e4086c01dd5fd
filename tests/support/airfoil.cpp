#include "tests/support/airfoil.hpp"

#include "tests/support/random_curves.hpp"

#include <cmath>

namespace forefront::testing {

namespace {

double slopeOfHalfThickness(double s, double thickness) {
    const double q = s * s;
    return 5.0 * thickness *
           (0.2969 + s * (-2.0 * 0.1260 + q * (-4.0 * 0.3516 + q * (6.0 * 0.2843 - q * 8.0 * 0.1036))));
}

/// Returns one side of the aerofoil from s0 to s1, with the tangents of the formula at both ends.
Curve sideOf(double s0, double s1, double sign) {
    constexpr double kThickness = 0.12;
    const auto place = [&](double s) { return Vec2{s * s, sign * halfThickness(s)}; };
    const auto third = [&](double s) {
        return (s1 - s0) / 3.0 * Vec2{2.0 * s, sign * slopeOfHalfThickness(s, kThickness)};
    };
    return Curve::cubic(place(s0), place(s0) + third(s0), place(s1) - third(s1), place(s1));
}

} // namespace

Domain discDomain() {
    return curvedDomain({{Curve::circle({0, 0}, {1, 0})}}, 1e-4);
}

double halfThickness(double s, double thickness) {
    const double q = s * s;
    return 5.0 * thickness * (0.2969 * s + q * (-0.1260 + q * (-0.3516 + q * (0.2843 - q * 0.1036))));
}

Domain airfoilDomain() {
    constexpr int kPieces = 6;
    CurveLoop airfoil;
    for (int i = kPieces; i > 0; --i) { // above, from the trailing edge to the nose
        airfoil.push_back(sideOf(static_cast<double>(i) / kPieces, static_cast<double>(i - 1) / kPieces, 1.0));
    }
    for (int i = 0; i < kPieces; ++i) {
        airfoil.push_back(sideOf(static_cast<double>(i) / kPieces, static_cast<double>(i + 1) / kPieces, -1.0));
    }
    const CurveLoop outline = {Curve::line({-1, -1}, {2, -1}), Curve::line({2, -1}, {2, 1}),
                               Curve::line({2, 1}, {-1, 1}), Curve::line({-1, 1}, {-1, -1})};
    return curvedDomain({outline, airfoil}, 1e-5);
}

} // namespace forefront::testing
