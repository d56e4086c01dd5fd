#pragma once

#include "core/engine/spacing/spacing_field.hpp"

namespace forefront {

/// Builds the field of a specification alone, without the limits that follow from the treatment of the domain's
/// segments in the mesh. Errors: as for SpacingField::build().
Result<std::shared_ptr<const SpacingField>> fieldOfRules(const SpacingSpec &spec, const Domain &domain,
                                                         const Progress &progress);

} // namespace forefront
