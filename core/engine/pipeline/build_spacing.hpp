#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <memory>

namespace forefront {

/// Builds the node spacing of a job. Errors: as for SpacingField::build().
Result<std::shared_ptr<const SpacingField>> buildSpacing(const MeshingJob &job, const Progress &progress);

} // namespace forefront
