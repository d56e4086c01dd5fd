#pragma once

#include "core/engine/spacing/sites/size_site.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <memory>
#include <vector>

namespace forefront {

/// Returns a field that is the minimum of another one and of the sizes of sites, such as the tops of boundary layers.
/// `sites` may be empty. `what`: what they are, for the inspector; a literal. Error: cancelled.
Result<std::shared_ptr<const SpacingField>> layeredField(std::shared_ptr<const SpacingField> others,
                                                         std::vector<SizeSite> sites, const Box2 &box,
                                                         const Progress &progress,
                                                         const char *what = "the last boundary layer");

} // namespace forefront
