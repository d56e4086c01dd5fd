#pragma once

#include "core/drawing/document/document.hpp"
#include "core/files/json/json_check.hpp"
#include "core/files/json/json_text.hpp"

namespace forefront {

/// Writes the member "regionElements" of a project; nothing without any.
void writeRegionElements(const Document &document, JsonText &out);

/// Reads the shapes of elements of regions. A region that occurs twice is a fault.
void readRegionElements(const JsonValue &root, Document &document, JsonCheck &check);

} // namespace forefront
