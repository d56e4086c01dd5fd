#pragma once

#include "core/engine/geometry/curve.hpp"

#include <numbers>

namespace forefront {

/// Limits on the chords of a curve. A chord may turn by 1/8 of a full turn, so that a circle keeps its shape however
/// large the spacing. Where that would be much finer than the tolerance, as on the rounding of an edge, by 1/3.
struct ChordLimit {
    static constexpr double kMaxTurn = std::numbers::pi / 4.0;
    static constexpr double kMaxTinyTurn = 2.0 * std::numbers::pi / 3.0;
    static constexpr double kTiny = 1.0 / 16.0;  ///< of the tolerance
    static constexpr double kCusp = 1.0 / 256.0; ///< likewise; such a part may even turn back

    /// Returns the longest chord of a curve with the given curvature (> 0) that is within `tolerance` of it.
    static double longest(double curvature, double tolerance);
    /// Returns the longest chord at a parameter of a curve; infinite where it is straight, 0 at a cusp.
    static double longestAt(const Curve &curve, double t, double tolerance);
};

/// Returns the curvature of a curve at a parameter, >= 0; not finite where the curve stands still.
double curvatureAt(const Curve &curve, double t);

} // namespace forefront
