#pragma once

#include "core/engine/spacing/spacing_field.hpp"

namespace forefront {

/// Builds the field of a specification alone, without the limits that follow from what the mesh makes of the segments
/// of the domain. Errors: those of SpacingField::build().
Result<std::shared_ptr<const SpacingField>> fieldOfRules(const SpacingSpec &spec, const Domain &domain,
                                                         const Progress &progress);

} // namespace forefront
