#pragma once

#include "core/engine/domain/domain.hpp"

#include <cstdint>
#include <map>

namespace forefront::testing {

/// Returns ½ ∫ C × dC along a part of a curve, relative to an origin: the area that the part sweeps as seen from there.
/// Uses closed formulas.
double sweptArea(const Curve &curve, double t0, double t1, Vec2 origin);

/// Returns the exact area inside a valid domain by region tag, along the curves that its segments follow.
std::map<std::int32_t, double> curvedAreas(const Domain &domain);

} // namespace forefront::testing
