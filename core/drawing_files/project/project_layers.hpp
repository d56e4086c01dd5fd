#pragma once

#include "core/drawing/document/document.hpp"
#include "core/files/json/json_check.hpp"
#include "core/files/json/json_text.hpp"

namespace forefront {

/// Writes the member "layers" of a project, if there are any.
void writeLayers(const Document &document, JsonText &out);
/// Reads the member "layers" of a project.
void readLayers(const JsonValue &root, Document &document, JsonCheck &check);

} // namespace forefront
