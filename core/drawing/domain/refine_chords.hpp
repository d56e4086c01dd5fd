#pragma once

#include "core/drawing/domain/domain_sources.hpp"
#include "core/engine/domain/domain.hpp"

namespace forefront {

/// Halves chords of curves that cross or touch other segments, until they do not: curves that come nearer to each other
/// than their chords deviate do not meet. Curves that really meet are left to validation. Leaves the domain as it is if
/// others still meet after 12 rounds, or if it would get thousands of nodes more. Keeps `sources`, which may be null,
/// in step.
void refineMeetingChords(Domain &domain, DomainSources *sources);

} // namespace forefront
