#pragma once

#include "core/engine/pipeline/meshing_state.hpp"
#include "core/engine/session/snapshot.hpp"

#include <cstdint>
#include <memory>

namespace forefront {

/// The mesh that a run ends with, and its figures.
struct FinishedMesh {
    std::shared_ptr<const MeshSnapshot> view;
    std::shared_ptr<const DiscreteDomain> boundary; ///< of this mesh, whose edges a least angle may have divided
    MeshQuality quality;
    std::uint64_t hash = 0;
    std::shared_ptr<const SecondOrderReport> order;     ///< null: of first order
    std::shared_ptr<const LeastAngleReport> leastAngle; ///< null: none was asked for

    /// Fills in the mesh and its figures.
    void fill(SessionSnapshot &snapshot) const;
};

/// Takes the mesh of a run whose last stage is done. `number`: of the run, which makes the version of the mesh view.
FinishedMesh takeFinished(MeshingState &state, std::uint64_t number);

} // namespace forefront
