#pragma once

#include "core/engine/spacing/spacing_field.hpp"

#include <memory>

namespace forefront {

/// Returns a field with `factor` (> 0) times the spacing of another field.
std::shared_ptr<const SpacingField> scaledField(std::shared_ptr<const SpacingField> field, double factor);

} // namespace forefront
