#pragma once

#include "app/batch/inputs.hpp"
#include "app/batch/mesh_arguments.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesher/options.hpp"

#include <span>

namespace forefront {

/// Gives a job what the command line asks for single parts and regions: elements, layers, cracks, strips, periodic
/// parts, mapped regions. `periodicOfMesh`: parts that a mesh shows as periodic; those that the rest excludes are left
/// out, with notes. Returns the first faults: unknown names, with their places in the file.
Diagnostics applyPartOptions(const MeshArguments &arguments, const Input &input,
                             std::span<const PeriodicSpec> periodicOfMesh, MeshingJob &job);

} // namespace forefront
