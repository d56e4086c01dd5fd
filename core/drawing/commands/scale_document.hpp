#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

namespace forefront {

/// Scales a whole document about a point, as if its unit of length were changed: the drawing, the background picture
/// and all element sizes, with the formulas of lengths and areas. A spacing expression does not change. Formulas that
/// do not match their numbers are removed. Errors: bad-number for a factor that is not positive and finite, bad-shape.
Result<Document> scaleDocument(const Document &document, Vec2 fixed, double factor);

} // namespace forefront
