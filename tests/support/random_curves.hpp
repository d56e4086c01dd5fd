#pragma once

#include "core/engine/domain/domain.hpp"

#include <cstdint>
#include <vector>

namespace forefront::testing {

/// Families of domains with curved boundaries.
enum class CurveFamily : std::uint8_t {
    Circles,     ///< circles inside one another, some of them nearly touching
    Rounded,     ///< polygons with rounded corners of any radius
    Blobs,       ///< smooth closed Bézier curves, one inside another at a small distance
    Ellipses,    ///< ellipses anywhere, which may cross
    Crescents,   ///< pairs of arcs that share their ends and bend the same way
    Constraints, ///< a circle with curved lines and points in it
    Cusps        ///< closed cubics with cusps, loops and vanishing derivatives, which cross themselves
};
inline constexpr int kCurveFamilies = 7;
const char *nameOf(CurveFamily family);

/// A closed curve in parts, each beginning where the previous one ends.
using CurveLoop = std::vector<Curve>;

/// Builds the domain that the loops bound by the even-odd rule, from chords that deviate by at most `deviation`. Parts
/// within `weld` of each other are joined.
Domain curvedDomain(const std::vector<CurveLoop> &loops, double deviation, double weld = 0.0);

/// Returns a valid domain, always the same for the same family and seed.
Domain randomCurvedDomain(CurveFamily family, std::uint64_t seed);
/// Returns a domain of the family seed modulo kCurveFamilies.
Domain randomCurvedDomain(std::uint64_t seed);

} // namespace forefront::testing
