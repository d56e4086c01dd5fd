#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/domain/periodic.hpp"

#include <cstdint>
#include <span>

namespace forefront {

/// Returns the faults of the cracks of a valid domain. `cracks`: tags. `faces`: of the domain.
///
/// Errors: unknown-boundary (no segment has the tag), repeated-crack, crack-outside (a segment has the domain on one
/// side alone), crack-periodic (a crack ends on a periodic part, whose nodes are paired one to one).
Diagnostics checkCrackLines(std::span<const std::int32_t> cracks, std::span<const PeriodicSpec> periodic,
                            const Domain &domain, const DomainFaces &faces);

} // namespace forefront
