#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/pipeline/pipeline.hpp"

#include <span>

namespace forefront {

/// Leaves out of a job those of some periodic parts that it excludes: those with boundary layers, and those that a
/// crack or a strip touches. `ofMesh`: parts that a mesh file shows as periodic, which nobody asked for. Returns notes
/// on what was left out.
Diagnostics leaveOutExcludedPeriodic(MeshingJob &job, std::span<const PeriodicSpec> ofMesh);

} // namespace forefront
