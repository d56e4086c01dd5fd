#pragma once

#include "core/drawing/document/document.hpp"
#include "core/files/json/json_check.hpp"
#include "core/files/json/json_text.hpp"

namespace forefront {

/// Writes the members "openBoundaries" and "elevation" of a project; nothing for one that is empty.
void writeWater(const Document &document, JsonText &out);

/// Reads them. A tag that occurs twice is a fault.
void readWater(const JsonValue &root, Document &document, JsonCheck &check);

} // namespace forefront
