#pragma once

#include "core/engine/geometry/curve_part.hpp"

#include <vector>

namespace forefront {

/// A place where two curves cross, or touch within a tolerance.
struct CurveContact {
    double first = 0.0;  ///< parameter on the first curve
    double second = 0.0; ///< parameter on the second curve
    Vec2 onFirst;        ///< the same place on both where they cross
    Vec2 onSecond;
    bool crossing = false;
};

/// Maximum angle between a part and its chord for curveContacts(), in radians.
inline constexpr double kMaxContactTurn = 0.3;

/// Finds where two parts of curves cross, and where they come within `tolerance` (positive) of each other and part
/// again. Misses no crossing beyond which they are farther apart than the tolerance; several shallower ones in a row
/// count as one contact. Where they are within the tolerance up to an end of one of them, there is no contact: that end
/// marks where they meet. Depends on the geometry alone, not on which part is the first. Both parts must turn by at
/// most kMaxContactTurn from their chords.
std::vector<CurveContact> curveContacts(const CurvePart &first, const CurvePart &second, double tolerance);

} // namespace forefront
