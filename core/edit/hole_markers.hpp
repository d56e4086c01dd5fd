#pragma once

#include "core/domain/domain.hpp"

namespace forefront {

/// The same inside and outside by the even-odd rule: of a domain under InsideRule::HoleMarkers, a segment with the
/// inside on exactly one side becomes Boundary, one with the inside on both sides a Constraint; one with the outside on
/// both sides bounds nothing and is left out. Nodes, tags, points, names and region markers stay; hole markers are
/// used up. Where segments cross there are no faces to tell: then every segment keeps its role, for validation to
/// report.
Domain withEvenOddRoles(const Domain &domain);

} // namespace forefront
