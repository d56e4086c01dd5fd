#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

#include <string_view>

namespace forefront {

/// Returns the paths and points in lines of coordinates; see readClipboard(). Errors: no-drawing.
Result<Document> readCoordinates(std::string_view text);

} // namespace forefront
