#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <memory>

namespace forefront {

/// Lowers nodal values so that they grow by at most `gradation` per unit of length along every edge. The mesh must be
/// valid. O(n log n). Returns false when cancelled.
bool limitGradation(BackgroundMesh &mesh, double gradation, const Progress &progress = {});

/// Returns the mesh with values limited like this; null if none has to be lowered, or when cancelled. Values below
/// `minimum` count as that.
std::shared_ptr<const BackgroundMesh> withoutSteepEdges(const BackgroundMesh &mesh, double minimum, double gradation,
                                                        const Progress &progress);

} // namespace forefront
