#pragma once

#include "core/engine/spacing/spec/spacing_spec.hpp"
#include "core/files/json/json_check.hpp"
#include "core/files/json/json_text.hpp"

namespace forefront {

/// Writes the member "spacing" of a project.
void writeSpacing(const SpacingSpec &spec, JsonText &out);
/// Reads the object "spacing" of a project; its faults are added to `check`.
SpacingSpec readSpacing(const JsonValue &object, JsonCheck &check);

} // namespace forefront
