#pragma once

#include "core/engine/base/vec2.hpp"
#include "core/engine/domain/domain.hpp"

#include <vector>

namespace forefront {

/// Converts a domain with hole markers to the even-odd rule with the same inside: a segment with the inside on one side
/// becomes Boundary, on both sides Constraint; a segment with the outside on both sides is removed, unless it belongs
/// to an open outline, which validation reports. Nodes, tags, points, names and region markers stay; hole markers are
/// removed. If segments cross there are no faces: all segments keep their roles, and validation reports the crossings.
Domain withEvenOddRoles(const Domain &domain);

/// Returns the hole markers that withEvenOddRoles() removes without effect: those that lie in no hole, or all if
/// segments cross.
std::vector<Vec2> idleHoleMarkers(const Domain &domain);

} // namespace forefront
