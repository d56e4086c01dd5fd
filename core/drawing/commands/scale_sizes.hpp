#pragma once

#include "core/drawing/document/document.hpp"

namespace forefront {

/// Multiplies every element size of a document by `factor` (> 0): see scaledSizes(). Formulas of sizes take the factor
/// along. Numbers of elements, the minimum and the curve tolerance stay.
Document scaleSizes(const Document &document, double factor);

} // namespace forefront
