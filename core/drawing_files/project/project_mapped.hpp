#pragma once

#include "core/drawing/document/document.hpp"
#include "core/files/json/json_check.hpp"
#include "core/files/json/json_text.hpp"

namespace forefront {

/// Writes the member "mapped" of a project; nothing without any.
void writeMapped(const Document &document, JsonText &out);

/// Reads the mapped regions of a project. A region that occurs twice is a fault.
void readMapped(const JsonValue &root, Document &document, JsonCheck &check);

} // namespace forefront
