#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/pipeline/meshing_state.hpp"
#include "core/engine/quads/even_boundary.hpp"

#include <memory>

namespace forefront {

/// What a two-coloured front starts from.
struct QuadStart {
    std::shared_ptr<const ColouredBoundary> boundary;
    bool lattice = false; ///< a lattice grows inside the rows along the boundary; else rows to the end
};

/// Makes the boundary of a prepared job even, which replaces `prepared.boundary`, and chooses the front that
/// quadFrontStage() would: both are run for that. Errors: those of the front, "cancelled".
Result<QuadStart> chooseQuadFront(MeshingState &state, const Progress &progress);

} // namespace forefront
