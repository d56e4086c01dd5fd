#pragma once

#include "core/base/api.hpp"
#include "core/base/result.hpp"
#include "core/domain/domain.hpp"

namespace FOREFRONT_API forefront {

/// Returns all faults of a domain, each with coordinates and parts; empty if the domain can be meshed.
///
/// Codes: non-finite, out-of-range (beyond 1e60, smaller than 1e-60, or too far from the origin for four digits),
/// empty-domain, bad-index, bad-tag, zero-length, duplicate-node, duplicate-segment, crossing-segments,
/// touching-segments (parts: node, segment), overlapping-segments, open-chain, unreferenced-node, hole-outside,
/// region-marker-outside, region-marker-conflict, point-outside, segment-outside. The last five depend on inside and
/// outside, so they are checked only if the segments are simple and closed. Exact predicates throughout; O(n log n) for
/// any input, plus the time to list the meetings. At most `limit` faults are listed; a last Note counts the rest.
Diagnostics validate(const Domain &domain, std::size_t limit = 200);

/// A repaired domain with one Note per change; the notes refer to parts of the given domain.
struct Repaired {
    Domain domain;
    Diagnostics changes;
};

/// Repairs a domain where that is safe: merges duplicate nodes, drops duplicate and zero-length segments and
/// unreferenced nodes, splits segments at crossings and touching nodes, and keeps overlapping parts once. Open chains,
/// non-finite numbers and an empty domain cannot be repaired; `validate` reports them afterwards. A valid domain is
/// returned unchanged; in others, ends of crossing segments may move onto each other by 1e-12 of the extent or a few
/// units in the last place. Errors: out-of-range, too-many-faults, repair-failed.
Result<Repaired> repair(const Domain &domain);

/// Returns true if `repair` removes faults of this kind.
bool repairable(const Diagnostic &fault);
/// Returns true if any of the faults is repairable.
bool anyRepairable(const Diagnostics &faults);

} // namespace forefront
