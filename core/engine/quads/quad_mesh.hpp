#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/engine/mesher/statistics.hpp"
#include "core/engine/quads/even_boundary.hpp"
#include "core/engine/quads/quad_report.hpp"
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

/// Cleans up a mesh at a level of improvement. Elements::Mixed then divides poor quadrilaterals. Returns false when
/// cancelled; the mesh is then valid.
bool cleanUp(QuadMesh &mesh, const SpacingField &spacing, const MeshingOptions &options, const Progress &progress);

/// Returns the mesh with the tags and names of its boundary, and its report with the final counts.
Mesh toMesh(QuadMesh &&mesh, const DiscreteDomain &boundary, QuadReport &report);

} // namespace forefront
