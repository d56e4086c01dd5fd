#pragma once

#include "core/base/api.hpp"
#include "core/base/diagnostic.hpp"
#include "core/mesh/mesh.hpp"

namespace FOREFRONT_API forefront {

struct DiscreteDomain;
struct Domain;

/// Faults of a mesh by itself: bad-index, non-finite, inverted-element, zero-area (exact sign), non-conforming (edge
/// with more than two elements, or two on the same side), overlapping, hanging-node, unreferenced-node,
/// missing-tagged-edge, euler.
Diagnostics verify(const Mesh &mesh, std::size_t limit = 50);

/// Also against what it was made of: every discrete boundary and constraint segment is an edge of the mesh with its
/// tag, every mesh boundary edge is one of them, every point is a node, region tags agree, and the area is the domain's
/// within rounding.
Diagnostics verifyAgainst(const Mesh &mesh, const DiscreteDomain &domain, std::size_t limit = 50);

/// Against a domain file: each domain segment is covered exactly by a chain of tagged mesh edges (collinear, exact for
/// kept nodes, within 1e-9 of the domain's size for inserted ones), boundary edges lie on domain segments, areas agree,
/// constraint points are nodes.
Diagnostics verifyAgainst(const Mesh &mesh, const Domain &domain, std::size_t limit = 50);

} // namespace forefront
