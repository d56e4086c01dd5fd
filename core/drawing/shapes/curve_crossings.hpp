#pragma once

#include "core/engine/geometry/curve.hpp"

#include <vector>

namespace forefront {

/// A place that two curves share.
struct CurveCrossing {
    double first = 0.0;  ///< parameter on the first curve
    double second = 0.0; ///< parameter on the second curve
    Vec2 at;             ///< on the first curve
};

/// Returns where two curves cross or touch, or where one ends on the other, in the order of the first parameter. Of
/// parts that run along each other there are the ends only. `tolerance` (> 0) is the distance within which curves
/// touch, in domain units.
std::vector<CurveCrossing> crossingsOf(const Curve &first, const Curve &second, double tolerance);

} // namespace forefront
