#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesh/mesh.hpp"

namespace FOREFRONT_API forefront {

struct DiscreteDomain;
struct Domain;

/// Returns the faults of a mesh taken by itself: bad-index, non-finite, repeated-node (an element refers to a node
/// twice), inverted-element, zero-area (exact sign), non-conforming (edge with more than two elements, or two on the
/// same side), overlapping, hanging-node, unreferenced-node, missing-tagged-edge, euler, out-of-memory; and as a
/// warning flat-element (its area is positive, but not by more than rounding of its nodes can explain). At most `limit`
/// entries, errors first; a kind of fault that occurs often is one entry with its count.
Diagnostics verify(const Mesh &mesh, std::size_t limit = kMaxListedFaults);

/// Returns the faults that verify(mesh) finds and, if no errors are among them, its deviations from its discrete
/// domain: every segment must be an edge of the mesh with its tag, every boundary edge of the mesh a segment, every
/// point a node; region tags must agree, and the areas must be equal within rounding.
Diagnostics verifyAgainst(const Mesh &mesh, const DiscreteDomain &domain, std::size_t limit = kMaxListedFaults);

/// Returns the faults that verify(mesh) finds and, if no errors are among them, its deviations from a domain: each
/// domain segment must be covered by a chain of tagged mesh edges (through the domain's nodes exactly, and through
/// inserted nodes within 1e-9 of the domain's size, or what rounding may move them far from the origin); boundary edges
/// must lie on domain segments, areas must agree, and constraint points must be nodes. Where segments follow a curve,
/// the inserted nodes must lie on the curve or on its chords.
Diagnostics verifyAgainst(const Mesh &mesh, const Domain &domain, std::size_t limit = kMaxListedFaults);

} // namespace forefront
