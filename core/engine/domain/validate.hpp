#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/domain/domain.hpp"

#include <cstddef>

namespace FOREFRONT_API forefront {

struct DomainFaces;

/// Returns all faults of a domain, each with coordinates and parts; empty if the domain can be meshed.
///
/// Codes: non-finite, out-of-range (beyond 1e60, smaller than 1e-60, or too far from the origin for four digits),
/// empty-domain, bad-index, bad-parameter, bad-tag, zero-length, duplicate-node, duplicate-segment, crossing-segments,
/// touching-segments (parts: node, segment), overlapping-segments, open-chain, unreferenced-node, hole-outside,
/// region-marker-outside, region-marker-conflict, point-outside, segment-outside. The last five depend on inside and
/// outside, so they are checked only if the segments are simple and closed. If memory runs out, the only one is
/// out-of-memory. Exact predicates throughout; O(n log n) for
/// any input, plus the time to list the meetings. At most `limit` faults are listed; a last Note counts the rest.
/// Where `faces` is given and the domain is valid, it receives the faces, which saves discretise() finding them again.
Diagnostics validate(const Domain &domain, std::size_t limit = kMaxListedFaults, DomainFaces *faces = nullptr);

} // namespace forefront
