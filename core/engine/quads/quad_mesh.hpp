#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/engine/mesher/statistics.hpp"
#include "core/engine/quads/coloured_mesher.hpp"
#include "core/engine/quads/even_boundary.hpp"
#include "core/engine/quads/quad_report.hpp"
#include "core/engine/quads/quad_watch.hpp"
#include "core/engine/quads/quad_workspace.hpp"

#include <memory>

namespace forefront {

/// A mesh of quadrilaterals between its front and its blocks.
struct QuadMesh {
    QuadWorkspace elements;
    QuadReport report;
    WorkCounters work;
};

/// The input of a two-coloured front. Refers to its parts.
struct QuadRequest {
    const ColouredBoundary &boundary;
    const SpacingField &spacing;
    const MeshingOptions &options;
    double estimatedElements = 0.0; ///< triangles of the same spacing, for the progress
    std::uint64_t maxElements = 0;  ///< quadrilaterals at which the front is stopped
};

/// Advances two fronts, one by rows to the end and one with a lattice, and joins their triangles. Keeps the one whose
/// mesh has the lower share of irregular nodes and follows the spacing better; the second front is left out if the
/// first has next to none. Returns false when cancelled or stopped; the mesh is then unusable.
bool advanceColoured(const QuadRequest &request, QuadMesh &mesh, const Progress &progress);

/// Returns the number of rows along the boundary after which the other legs of a front wait, see FrontLayers.
std::uint32_t rowsOfFront(bool lattice);

/// Joins the triangles of a closed front. `watch`: learns of the mesh once they are joined, and of each join of left
/// over triangles; null: none. QuadReport::lattice is left to the caller.
QuadMesh joinFront(ColouredTriangles triangles, const ColouredMesher &front, const MeshingOptions &options,
                   QuadWatch *watch);

/// Cleans up a mesh at a level of improvement. Elements::Mixed then divides poor quadrilaterals. Returns false when
/// cancelled; the mesh is then valid. `watch`: learns of each change; null: none.
bool cleanUp(QuadMesh &mesh, const SpacingField &spacing, const MeshingOptions &options, const Progress &progress,
             QuadWatch *watch = nullptr);

/// Returns the mesh with the tags and names of its boundary, and its report with the final counts.
Mesh toMesh(QuadMesh &&mesh, const DiscreteDomain &boundary, QuadReport &report);

} // namespace forefront
