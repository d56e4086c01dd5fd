#pragma once

#include "core/edit/document.hpp"
#include "core/edit/references.hpp"

namespace forefront {

/// `document` with the shapes, region markers and names of another one, scaled about the origin. Names of `document`
/// win where both have one. `added`, if not null, becomes the selection of what was added.
Document insertDrawing(const Document &document, const Document &other, double scale, Selection *added);

} // namespace forefront
