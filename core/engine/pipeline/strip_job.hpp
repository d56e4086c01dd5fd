#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/engine/spacing/sites/size_site.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "core/engine/strips/widened_domain.hpp"

#include <memory>
#include <vector>

namespace forefront {

/// A job whose strips are faces of its domain, as they are meshed.
struct StripJob {
    MeshingJob job;
    std::vector<StripFace> faces;
    std::vector<SizeSite> ends; ///< sizes at the ends of strips
};

/// Returns the field lowered around the ends of strips; `strips` may be null. Error: cancelled.
Result<std::shared_ptr<const SpacingField>> withStripEnds(std::shared_ptr<const SpacingField> spacing,
                                                          const StripJob *strips, const Progress &progress);

} // namespace forefront
