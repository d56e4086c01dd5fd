#pragma once

#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/domain_fault_list.hpp"

namespace forefront {

/// Adds the faults of single nodes, segments, points and markers of a domain: coordinates, indices, tags, curves,
/// lengths, and nodes that nothing uses. Returns true if all segments have a place; the geometry lacks those that have
/// none.
bool checkParts(const Domain &domain, DomainFaultList &faults);

} // namespace forefront
