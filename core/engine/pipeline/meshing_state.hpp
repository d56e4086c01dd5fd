#pragma once

#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/domain/periodic_sides.hpp"
#include "core/engine/improve/improve.hpp"
#include "core/engine/mesh/cracks.hpp"
#include "core/engine/mesh/mesh.hpp"
#include "core/engine/mesh/second_order.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/quads/quad_mesh.hpp"
#include "core/engine/refine/least_angle.hpp"

#include <limits>

namespace forefront {

/// The results of the stages of a run so far. Each stage reads the results of the earlier stages and adds its own.
struct MeshingState {
    const MeshingJob &job;
    /// The number of elements that the job is coarsened to; infinite: it is not.
    double budget = std::numeric_limits<double>::infinity();
    ImproveWatch *watch = nullptr;  ///< learns of each change of the improvement; null: none
    QuadWatch *quadWatch = nullptr; ///< learns of each change of the clean-up of quadrilaterals; null: none

    DomainFaces faces{};      ///< of the domain as it is meshed, once it is validated
    PeriodicSides periodic{}; ///< segments tied to others, once the domain is validated
    PreparedJob prepared{};   ///< the spacing, then the discretised boundary
    TriMesh triangles{};      ///< of the front
    QuadMesh quads{};         ///< of the two-coloured front
    WorkCounters work{};      ///< of the front
    ImproveReport improvement{};
    LeastAngleReport leastAngle{};
    QuadReport quadReport{};
    SecondOrderReport secondOrder{};
    CrackReport cracks{};
    Mesh mesh{}; ///< the result, once the last stage has run

    /// Returns the job as it is meshed: with strips as faces of the domain, once these are made.
    const MeshingJob &meshed() const;
};

} // namespace forefront
