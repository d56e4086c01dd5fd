#pragma once

#include "core/drawing/document/document.hpp"
#include "core/files/json/json_check.hpp"
#include "core/files/json/json_text.hpp"

namespace forefront {

/// Writes the member "periodic" of a project, if it has periodic parts.
void writePeriodic(const Document &document, JsonText &out);
/// Reads the member "periodic" of a project.
void readPeriodic(const JsonValue &root, Document &document, JsonCheck &check);

} // namespace forefront
