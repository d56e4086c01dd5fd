#pragma once

#include "core/engine/mesher/trace.hpp"

#include <string>

namespace forefront {

/// Returns why an ideal point was withdrawn: "the segment (1, 2)–(2, 2) is 0.449 ρ away, nearer than 0.5 ρ". The
/// candidate is blocked.
std::string clearanceText(const CandidateTrace &ideal, double rho);

/// Returns the number of digits after the point, from 2 to 4, at which scores that differ look different.
int scoreDigits(const AdvanceExplanation &advance);

} // namespace forefront
