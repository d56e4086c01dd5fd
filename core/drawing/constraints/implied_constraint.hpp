#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/diagnostic.hpp"

#include <cstdint>

namespace forefront {

/// Returns the error constraint-redundant for a constraint of a document that follows from no other constraint: it
/// names the formulas or locked shapes that set what the constraint demands, or says that the form of the shapes does.
Diagnostics impliedFault(const Document &document, std::uint32_t constraint);

} // namespace forefront
