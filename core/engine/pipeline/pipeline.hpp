#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/boundary/discretise.hpp"
#include "core/engine/improve/improve.hpp"
#include "core/engine/layers/boundary_layers.hpp"
#include "core/engine/mesh/cracks.hpp"
#include "core/engine/mesh/mesh.hpp"
#include "core/engine/mesh/second_order.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/engine/mesher/statistics.hpp"
#include "core/engine/quads/quad_report.hpp"
#include "core/engine/refine/least_angle.hpp"

#include <limits>
#include <memory>
#include <string_view>

namespace FOREFRONT_API forefront {

class Mesher;
struct StripJob;

/// A job that passed validation, with its discretised boundary and spacing field.
struct PreparedJob {
    std::shared_ptr<const DiscreteDomain> boundary;
    std::shared_ptr<const SpacingField> spacing;
    std::shared_ptr<const BoundaryLayers> layers; ///< null: none are asked for
    std::shared_ptr<const StripJob> strips;       ///< the job with strips as faces; null: it has no strips
    QuadReport quads;                             ///< of regions with quadrilaterals, where the others have triangles
    double estimatedElements = 0.0;
    double requestedElements = 0.0; ///< the estimate for the spacing of the job
    double coarsening = 1.0;        ///< ratio of `spacing` to the spacing of the job; see prepare()

    /// Returns the boundary that the front starts from: what the layers leave free, or `boundary` without layers.
    const std::shared_ptr<const DiscreteDomain> &frontBoundary() const { return layers ? layers->outer : boundary; }
    /// Returns what became of the boundary layers; null: there are none.
    std::shared_ptr<const LayerReport> layerReport() const {
        return layers && layers->report.rays > 0 ? std::shared_ptr<const LayerReport>(layers, &layers->report)
                                                 : nullptr;
    }
};

/// Validates the domain, builds the spacing, discretises the boundary and builds the boundary layers. If the estimated
/// number of elements exceeds `budget`, which must be positive, the spacing is multiplied by one factor that brings it
/// down to the budget, for a preview of the mesh; given nodes and edges stay, so that there may be more. Without a
/// budget, the estimate must not exceed MeshingOptions::maxElements. Where chords stand for curves that cross, sizes
/// for the short ones among them are added to an automatic spacing. Errors: those of each step, "too-many-elements",
/// "cancelled".
Result<PreparedJob> prepare(const MeshingJob &job, const Progress &progress = {},
                            double budget = std::numeric_limits<double>::infinity());

/// Does the same but meshes no region whose elements have other shapes than those of the job: enough to estimate a
/// mesh, and quick.
Result<PreparedJob> planMesh(const MeshingJob &job, const Progress &progress = {},
                             double budget = std::numeric_limits<double>::infinity());

/// The result of a run.
struct MeshingOutcome {
    Mesh mesh;
    std::shared_ptr<const DiscreteDomain> boundary;
    std::shared_ptr<const SpacingField> spacing;
    WorkCounters work;
    ImproveReport improvement;   ///< of triangles
    LeastAngleReport leastAngle; ///< of a mesh with a least angle
    QuadReport quads;            ///< of a mesh of quadrilaterals
    SecondOrderReport order;     ///< of a mesh of second order
    LayerReport layers;          ///< of a mesh with boundary layers
    CrackReport cracks;          ///< of a mesh with cracks
    double secondsMesh = 0.0;    ///< CPU time: the front, from discretised boundary to Γ = ∅
    double secondsImprove = 0.0; ///< CPU time of the improvement
    double secondsWall = 0.0;    ///< wall clock time of both; less than their sum where threads share the work
    double secondsPrepare = 0.0; ///< CPU time of validation, spacing and discretisation
};

/// Returns the number of elements at which a front is stopped, since its estimate was too low.
std::uint64_t elementsToStopAt(const MeshingOptions &options);
/// Returns the error "too-many-elements" for a front that was stopped there.
Diagnostics stoppedFront(const PreparedJob &prepared, const MeshingOptions &options);
/// Returns the error "out-of-memory".
Diagnostics outOfMemory();
/// Advances until Γ = ∅ and reports progress as `stage`. Errors: "too-many-elements", "cancelled".
Status advanceToEnd(Mesher &mesher, const PreparedJob &prepared, const MeshingOptions &options, std::string_view stage,
                    const Progress &progress);

/// Runs the whole pipeline: validates, builds the spacing, discretises, advances the front to its end, improves.
/// Errors: those of prepare(), "out-of-memory", "cancelled".
Result<MeshingOutcome> meshDomain(const MeshingJob &job, const Progress &progress = {});

} // namespace forefront
