#pragma once

#include "core/drawing/domain/domain_sources.hpp"
#include "core/engine/domain/domain.hpp"

namespace forefront {

/// Halves chords that cross or touch other segments although their curves do not, until they no longer do. Curves that
/// really meet are left to validation. Leaves the domain unchanged if other chords still meet after 12 rounds, or if
/// thousands of nodes would be added. Keeps `sources`, which may be null, in step.
void refineMeetingChords(Domain &domain, DomainSources *sources);

} // namespace forefront
