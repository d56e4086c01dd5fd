#pragma once

#include "core/drawing/document/document.hpp"
#include "core/files/json/json_check.hpp"
#include "core/files/json/json_text.hpp"

namespace forefront {

/// Writes the member "strips" of a project; nothing without any.
void writeStrips(const Document &document, JsonText &out);

/// Reads the strips of a project. A line that occurs twice, and numbers that are not valid, are faults.
void readStrips(const JsonValue &root, Document &document, JsonCheck &check);

} // namespace forefront
