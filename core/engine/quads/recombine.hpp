#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/improve/improve_level.hpp"
#include "core/engine/mesh/mesh.hpp"
#include "core/engine/quads/quad_report.hpp"

namespace FOREFRONT_API forefront {

/// Makes quadrilaterals of the triangles of a mesh. Triangles are joined in pairs over their common edges, those that
/// make the best quadrilaterals first; of the rest, each walks to another one through the quadrilaterals between
/// them. Then irregular nodes are removed and the others smoothed as `improve` says; the element size stays that of
/// the mesh. Boundary edges, interfaces between regions, tagged edges and tagged points stay where they are; nodes
/// inside move, and some are removed or added. In a face with an odd number of edges, one triangle remains; where a
/// quadrilateral between lines that must stay would have a corner of 180 degrees, two do.
///
/// Quadrilaterals of the mesh take part as they are. Errors: those of verify(), not-first-order (the mesh has elements
/// of second order), not-recombined (the result has a fault, with its place), cancelled. The mesh is then unchanged.
Result<QuadReport> recombine(Mesh &mesh, ImproveLevel improve = ImproveLevel::Default, const Progress &progress = {});

} // namespace forefront
