#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/domain/segment_elements.hpp"
#include "core/engine/mesh/mesh_numbers.hpp"
#include "core/engine/mesh/mesh_view.hpp"

#include <cstdint>
#include <span>

namespace FOREFRONT_API forefront {

struct DiscreteDomain;
struct Domain;

/// Returns the faults of a mesh taken by itself:
/// - bad-index, non-finite, repeated-node (an element refers to a node twice)
/// - inverted-element, zero-area (exact signs of its corners); concave-element (a quadrilateral with a flat or reflex
///   corner, or that crosses itself); folded-element (the Jacobian determinant of an element of second order is not
///   positive everywhere); as a warning flat-element (its area, or that of a corner of a quadrilateral, is positive,
///   but not by more than rounding of its nodes can explain)
/// - non-conforming (edge with more than two elements, or two on the same side), middle-node (elements do not share the
///   middle node of their edge, a tagged edge and its element have different ones, or the node is used elsewhere, too),
///   overlapping, hanging-node, missing-tagged-edge, euler
/// - out-of-memory
/// Nodes of no element are a note (unreferenced-node), and so are lines along which elements share no nodes although
/// their edges coincide (open-line), as along cracks. A mesh whose elements are all clockwise gets a warning
/// (clockwise) and is checked as if it were turned. Overlaps and hanging nodes are found between the chords of curved
/// edges: an element that bulges over another element across the outside of the mesh is not detected. At most `limit`
/// entries, errors first; a kind of fault that occurs often is one entry with its count. `numbers`: of the nodes and
/// elements in messages.
Diagnostics verify(const MeshView &mesh, std::size_t limit = kMaxListedFaults, const MeshNumbers &numbers = {});

/// Returns the faults of verify(mesh) and, if there are no errors, its deviations from its discrete domain: every
/// segment must be an edge of the mesh with its tag, every boundary edge of the mesh a segment, every point a node;
/// region tags must agree, and the areas must be equal within rounding. Curved edges are compared by their chords.
Diagnostics verifyAgainst(const MeshView &mesh, const DiscreteDomain &domain, std::size_t limit = kMaxListedFaults);

/// Returns the faults of verify(mesh) and, if there are no errors, its deviations from a domain: each domain segment
/// must be covered by a chain of tagged mesh edges (through the domain's nodes exactly, and through inserted nodes
/// within 1e-9 of the domain's size, or what rounding may move them far from the origin); boundary edges must lie on
/// domain segments, areas must agree, and constraint points must be nodes. Where segments follow a curve, the inserted
/// nodes must lie on the curve or on its chords. So must nodes in the middles of edges along segments (middle-node);
/// otherwise curved edges are compared by their chords. `innerTags`: false if the mesh carries no tags of edges inside
/// the domain, where constraints must then be edges, whichever tags they have. `elements`: PlacedSizes::elements of the
/// spacing; edges along a curve with a number of elements may be far from it. `cracks`: tags of inner lines that must
/// be cracks in the mesh, as verifyCracks() says; the mesh is compared with them closed.
Diagnostics verifyAgainst(const MeshView &mesh, const Domain &domain, SegmentElements elements = {},
                          std::size_t limit = kMaxListedFaults, const MeshNumbers &numbers = {}, bool innerTags = true,
                          std::span<const std::int32_t> cracks = {});

} // namespace forefront
