#pragma once

#include "core/drawing/arrangement/change.hpp"
#include "core/engine/base/api.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <cstdint>
#include <stop_token>
#include <vector>

namespace FOREFRONT_API forefront {

/// A repaired domain.
struct Repaired {
    Domain domain;
    std::vector<std::uint32_t> nodeSource;       ///< per node: the (first) input node it came from, or kNoIndex if new
    std::vector<std::uint32_t> nodeResult;       ///< per input node: the node that it became, or kNoIndex if it is gone
    std::vector<std::uint32_t> segmentSource;    ///< per segment: the input segment that it is part of
    std::vector<std::uint32_t> pointSource;      ///< per constraint point: the input point
    std::vector<std::uint32_t> holeMarkerSource; ///< per hole marker: the input marker
    double radius = 0.0; ///< joining distance: the tolerance, or less if several things are crowded within it
    std::vector<ArrangementChange> changes; ///< one entry per kind; indices refer to the given domain
};

/// Repairs a domain the way arrange() treats a drawing: crossings, contacts and overlaps become nodes, nodes and
/// segments closer than the tolerance (in domain units; at least the resolution of the coordinates) are joined,
/// repeated and empty segments and unreferenced nodes disappear.
/// - Inside and outside follow the domain's own rule. Of boundary segments that coincide an even number of times, one
///   stays if the boundary is then closed (a loop given twice is one loop); otherwise they bound nothing and become a
///   constraint inside the domain and disappear outside. Once the boundary is closed, lines and points outside
///   disappear too. With hole markers, a line that nearly closes stays: it may be an outline with a gap.
/// - With hole markers, the part of a hole beyond an outline that the hole crosses is left out, as with EvenOdd.
/// - Segments keep tags and their parts of curves, points their tags; markers and names stay. Where segments coincide,
///   the tag is that of the first boundary segment, or else of the first constraint.
/// - Nodes keep their order. Nothing moves farther than the tolerance. With the tolerance 0, a domain whose segments
///   meet only at common ends keeps all its nodes. Open loops, invalid numbers and misplaced markers cannot be
///   repaired; `validate` reports them afterwards. Errors: out-of-range, repair-failed,
///   out-of-memory, cancelled.
Result<Repaired> repair(const Domain &domain, double tolerance = 0.0, std::stop_token stop = {});

/// Transfers the sizes and numbers of elements along segments from a domain to its repaired version: each part of a
/// straight segment has the elements that lie in it, about as long as they were. All other sizes belong to tags or
/// positions, which a repair does not change. Returns a warning "lost-elements" for each segment whose number or bias
/// its parts cannot keep; their `parts` are segments of `before`.
Diagnostics carryElements(const Domain &before, const Repaired &repaired, SpacingSpec &spacing);

/// Returns true if `repair` removes faults of this kind.
bool repairable(const Diagnostic &fault);
/// Returns true if any of the faults is repairable.
bool anyRepairable(const Diagnostics &faults);

} // namespace forefront
