#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

#include <string>

namespace forefront {

/// Gives a document another unit and scales its coordinates and sizes, so that it keeps its real size: see
/// scaleDocument().
///
/// Parameters keep their numbers, which still are lengths in the unit before. The formulas of lengths are multiplied by
/// a parameter for that unit, such as mm = 1/25.4 in inches: "d" becomes "d*mm". Formulas that are so already keep
/// their text, since the value of that parameter changes instead, and back in their own unit they lose the factor. A
/// parameter for a unit that is also used in another way, as in another parameter, keeps its value, and its formulas
/// are multiplied like all others. Without a unit before or after, only the unit is set. Errors: those of
/// scaleDocument(); bad-parameter if there would be more than kMaxParameters.
Result<Document> convertUnit(const Document &document, LengthUnit unit);

/// Returns the name of the parameter that the formulas of a document are, or would be, multiplied by for a unit: its
/// word, or another name if a parameter of another meaning has that.
std::string unitParameter(const Document &document, LengthUnit unit);

} // namespace forefront
