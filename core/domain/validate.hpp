#pragma once

#include "core/base/api.hpp"
#include "core/base/result.hpp"
#include "core/domain/domain.hpp"

namespace FOREFRONT_API forefront {

/// All faults of a domain at once, each with coordinates and parts; empty when the domain can be meshed.
/// Codes: non-finite, out-of-range (beyond 1e60, smaller than 1e-60, or too far from the origin for four digits),
/// empty-domain, bad-index, bad-tag, zero-length, duplicate-node, duplicate-segment, crossing-segments,
/// touching-segments (parts: node, segment), overlapping-segments, open-chain, unreferenced-node, hole-outside,
/// region-marker-outside, region-marker-conflict, point-outside, segment-outside. What needs inside and outside (the
/// last five) is asked once the segments are simple and closed. Exact predicates throughout; O(n log n) whatever the
/// input, but for listing the meetings. At most `limit` faults are listed and the rest counted in a last Note.
Diagnostics validate(const Domain &domain, std::size_t limit = 200);

/// What `repair` changed; one Note each in `changes`, with parts of the domain as it was given.
struct Repaired {
    Domain domain;
    Diagnostics changes;
};

/// Safe repairs, only on request: merges duplicate nodes, drops duplicate and zero-length segments and unreferenced
/// nodes, splits segments at crossings and touching nodes, drops overlapping parts. What cannot be repaired safely
/// (open chains, non-finite numbers, empty domain) stays and is reported by `validate` afterwards. A valid domain comes
/// back as it is; of others, ends of crossing segments may move by 1e-12 of the extent (or some last digits) onto each
/// other. Errors: out-of-range, too-many-faults, repair-failed.
Result<Repaired> repair(const Domain &domain);

} // namespace forefront
