#pragma once

#include "core/engine/mesher/trace.hpp"

#include <array>
#include <vector>

namespace forefront {

/// A side of an element, from one place to another.
using PlacedSide = std::array<Vec2, 2>;

/// Returns the sides that a candidate would add: of a square those without a segment of Γ, of an apex one from each
/// node that it joins.
std::vector<PlacedSide> sidesOf(const AdvanceExplanation &advance, const CandidateTrace &candidate);

/// Returns the sides of the elements that an advance made, beyond their bases, without the one that the two halves of a
/// square share.
std::vector<PlacedSide> newSidesOf(const AdvanceExplanation &advance);

} // namespace forefront
