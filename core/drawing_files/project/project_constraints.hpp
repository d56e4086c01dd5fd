#pragma once

#include "core/drawing/document/document.hpp"
#include "core/files/json/json_check.hpp"
#include "core/files/json/json_text.hpp"

#include <cstdint>
#include <map>

namespace forefront {

/// Writes the member "constraints" of a project, if there are any.
void writeConstraints(const Document &document, JsonText &out);
/// Reads the member "constraints" of a project whose shapes were read. Nothing moves, even if a constraint does not
/// hold. `renumbered` maps the ids of shapes in the file to those that replaced them. Faults are added to `check`.
void readConstraints(const JsonValue &root, const std::map<std::uint32_t, std::uint32_t> &renumbered,
                     Document &document, JsonCheck &check);

} // namespace forefront
