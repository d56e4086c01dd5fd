#pragma once

#include "core/drawing/document/document.hpp"
#include "core/files/json/json_check.hpp"
#include "core/files/json/json_text.hpp"

namespace forefront {

/// Writes the member "cracks" of a project; nothing without any.
void writeCracks(const Document &document, JsonText &out);

/// Reads the cracks of a project. A tag that occurs twice is a fault.
void readCracks(const JsonValue &root, Document &document, JsonCheck &check);

} // namespace forefront
