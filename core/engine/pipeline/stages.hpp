#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/layers/layer_rows.hpp"
#include "core/engine/pipeline/meshing_state.hpp"

#include <cstdint>
#include <span>

namespace forefront {

/// The figure of a run that the time of a stage counts in; see MeshingOutcome.
enum class StageTime : std::uint8_t { Prepare, Mesh, Improve };

/// A stage of a run. Each one is a file of this folder; a new one is a new row of stages().
struct Stage {
    StageTime time = StageTime::Mesh;
    Status (*run)(MeshingState &, const Progress &) = nullptr; ///< does the work and returns its faults
    /// Returns true if a run with these options has the stage; null: each has.
    bool (*applies)(const MeshingOptions &) = nullptr;
};

/// Refuses domains that cannot be meshed. Sets `faces`.
Status validateStage(MeshingState &state, const Progress &progress);
/// Builds the node spacing. Sets `prepared.spacing`.
Status spacingStage(MeshingState &state, const Progress &progress);
/// Makes faces of the strips of the job. Sets `prepared.strips`; replaces `prepared.spacing`, `faces` and `periodic`.
/// Errors: those of widenedDomain().
Status stripsStage(MeshingState &state, const Progress &progress);
/// Discretises the boundary and estimates the number of elements. Sets the rest of `prepared`.
Status boundaryStage(MeshingState &state, const Progress &progress);
/// Fills the mapped faces of the job. Sets `prepared.layers`; may replace `prepared.boundary`. Errors: those of
/// findMappedFaces(), equalNumbers() and mappedRows(), "too-many-elements".
Status mappedStage(MeshingState &state, const Progress &progress);
/// Builds the boundary layers that the job asks for. Sets `prepared.layers`; replaces `prepared.boundary` and
/// `prepared.spacing`. Errors: those of buildLayers(), "too-many-elements", "layers-crossing" (what the layers leave
/// free has no consistent outline).
Status layersStage(MeshingState &state, const Progress &progress);
/// Returns the rows that layersStage() would make, before it. Errors: those of layerRows().
Result<LayerRows> rowsOfLayers(const MeshingState &state, const Progress &progress);
/// Meshes the regions whose elements have other shapes than those of the job's options. Sets `prepared.layers`; may
/// replace `prepared.boundary`. Errors: those of the front.
Status regionElementsStage(MeshingState &state, const Progress &progress);
/// Advances the front until Γ = ∅. Sets `triangles` and `work`.
Status frontStage(MeshingState &state, const Progress &progress);
/// Improves the triangles at the level of the job.
Status improveStage(MeshingState &state, const Progress &progress);
/// Refines the triangles until no angle is below the least one of the job. Replaces `prepared.boundary`; sets
/// `leastAngle`. Errors: those of refineToLeastAngle().
Status leastAngleStage(MeshingState &state, const Progress &progress);
/// Makes the boundary even and advances the two-coloured front. Replaces `prepared.boundary`; sets `quads` and `work`.
Status quadFrontStage(MeshingState &state, const Progress &progress);
/// Cleans up the quadrilaterals at the level of the job.
Status quadCleanupStage(MeshingState &state, const Progress &progress);
/// Makes the mesh of blocks from the quadrilaterals. Sets `mesh` and `quadReport`.
Status quadBlocksStage(MeshingState &state, const Progress &progress);
/// Makes the mesh of blocks, to which the triangles move.
Status blocksStage(MeshingState &state, const Progress &progress);
/// Adds the boundary layers to `mesh`.
Status joinStage(MeshingState &state, const Progress &progress);
/// Adds nodes in the middles of edges. Changes `mesh` to one of second order; sets `secondOrder`.
Status orderStage(MeshingState &state, const Progress &progress);
/// Opens the cracks of the job in `mesh`. Sets `cracks`. Errors: those of openCracks().
Status cracksStage(MeshingState &state, const Progress &progress);
/// Gives `mesh` the periodic links of the boundary, and pairs their nodes. Faults: those of verifyPeriodic().
Status periodicStage(MeshingState &state, const Progress &progress);
/// Checks the mesh of blocks against the domain. Faults: those of verifyAgainst().
Status verifyStage(MeshingState &state, const Progress &progress);

/// Adds the report on one part of a mesh to that of the whole.
void addReport(QuadReport &whole, const QuadReport &part);

/// The stages before the front, those that make it, and those after it, in order. A front may also be made step by
/// step, between the first and the last.
std::span<const Stage> stagesBeforeFront();
/// The first of the stages before the front: they plan the mesh, and mesh no region whose elements have other shapes.
std::span<const Stage> stagesOfPlan();
/// The first of the stages of a plan: all that come before boundary layers.
std::span<const Stage> stagesBeforeLayers();
std::span<const Stage> stagesOfFront();
std::span<const Stage> stagesAfterFront();
/// The first of the stages after the front: they make a mesh of the shapes of the job's options.
std::span<const Stage> stagesOfShapes();

/// Runs the stages that the options have, in order, until one of them has an error. Returns its faults, or "cancelled".
Status runStages(std::span<const Stage> stages, MeshingState &state, const Progress &progress);

} // namespace forefront
