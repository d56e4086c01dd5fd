#pragma once

#include "core/engine/pipeline/pipeline.hpp"

#include <cstdint>
#include <string>

namespace forefront::testing {

/// Meshes a job; the test ends if it is refused.
MeshingOutcome meshedJob(const MeshingJob &job);

/// Returns the code of the fault for which a job is refused; empty if it is meshed.
std::string refusalOf(const MeshingJob &job);

/// Returns the number of edges of a boundary part.
std::size_t edgesTagged(const Mesh &mesh, std::int32_t tag);

} // namespace forefront::testing
