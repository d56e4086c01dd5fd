#pragma once

#include "core/drawing/document/document.hpp"
#include "core/files/json/json_check.hpp"
#include "core/files/json/json_text.hpp"

namespace forefront {

/// Writes the member "elementCounts" of a project, if there are any.
void writeElementCounts(const Document &document, JsonText &out);
/// Reads the member "elementCounts" of a project whose spacing was read. The sizes that "partSizes" has for the same
/// tags, which older programs use, are dropped.
void readElementCounts(const JsonValue &root, Document &document, JsonCheck &check);

} // namespace forefront
