#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/layers/boundary_layers.hpp"
#include "core/engine/mapped/mapped_faces.hpp"
#include "core/engine/strips/widened_domain.hpp"

#include <span>

namespace forefront {

/// Fills mapped faces by rows of elements, and returns them with what they leave to the front, like boundary layers.
///
/// The nodes inside a face lie where transfinite interpolation of its sides puts them, at the fractions of the lengths
/// of opposite sides (W. J. Gordon, C. A. Hall, "Construction of curvilinear co-ordinate systems and applications to
/// mesh generation", Int. J. Numer. Meth. Engng 7, 1973). Where an element would be inverted, they are moved to a
/// solution of Winslow's equations (A. M. Winslow, J. Comput. Phys. 1, 1966), and where the outline turns inwards as
/// untangleRows() says. With 3 corners, the first row consists of triangles about the first corner. Without
/// TransfiniteFace::quads, each quadrilateral is divided into two triangles by the diagonal with the larger least
/// angle.
///
/// Strips are filled by straight lines between opposite nodes of their sides, with elements as they ask for.
///
/// `boundary`: discretised with equal numbers of edges on opposite sides. Errors: mapped-sides (the numbers differ),
/// mapped-corners (a corner of a face of quadrilaterals turns inwards), mapped-inverted (an element is inverted), both
/// with their places, cancelled. The caller limits the number of elements.
Result<BoundaryLayers> mappedRows(const Domain &domain, std::span<const TransfiniteFace> faces,
                                  std::span<const StripFace> strips, const DiscreteDomain &boundary,
                                  const Progress &progress = {});

/// Returns a mesh without elements that has the nodes, curves and names of a boundary.
TriMesh nodesOf(const DiscreteDomain &boundary);

} // namespace forefront
