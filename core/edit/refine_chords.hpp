#pragma once

#include "core/domain/domain.hpp"
#include "core/edit/domain_sources.hpp"

namespace forefront {

/// Halves chords of curves that cross or touch other segments, until they do not: curves that come nearer to each other
/// than their chords deviate do not meet. Leaves the domain as it is if chords still meet after 12 rounds, because some
/// curves really do, or if it would get thousands of nodes more. Keeps `sources`, which may be null, in step.
void refineMeetingChords(Domain &domain, DomainSources *sources);

} // namespace forefront
