#pragma once

#include "core/base/result.hpp"
#include "core/edit/document.hpp"

#include <string_view>

namespace forefront {

/// Returns the paths and points in lines of coordinates; see readClipboard(). Errors: no-drawing.
Result<Document> readCoordinates(std::string_view text);

} // namespace forefront
