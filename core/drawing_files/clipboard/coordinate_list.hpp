#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"
#include "core/files/source/import_notes.hpp"

#include <string_view>

namespace forefront {

/// Returns the paths and points in lines of coordinates; see readClipboard(). Errors: no-drawing. `notes`: receives
/// notes on unused lines; may be null.
Result<Document> readCoordinates(std::string_view text, ImportNotes *notes);

} // namespace forefront
