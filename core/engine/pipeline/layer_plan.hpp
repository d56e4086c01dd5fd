#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/layers/layer_rows.hpp"
#include "core/engine/mesher/options.hpp"

namespace FOREFRONT_API forefront {

/// Returns the rows of the boundary layers of a job, without making them: quick enough to follow each change of a
/// drawing. There are none if the job has no layers. Errors: those of prepare() up to the layers.
Result<LayerRows> planLayerRows(const MeshingJob &job, const Progress &progress = {});

} // namespace forefront
