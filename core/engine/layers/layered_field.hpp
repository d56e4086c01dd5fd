#pragma once

#include "core/engine/spacing/sites/size_site.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <memory>
#include <vector>

namespace forefront {

/// Returns a field that is the minimum of another one and of the sizes of the tops of boundary layers. `tops` may be
/// empty. Error: cancelled.
Result<std::shared_ptr<const SpacingField>> layeredField(std::shared_ptr<const SpacingField> others,
                                                         std::vector<SizeSite> tops, const Box2 &box,
                                                         const Progress &progress);

} // namespace forefront
