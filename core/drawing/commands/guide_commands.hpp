#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

#include <cstddef>

namespace forefront {

// Commands on the guides of a document. Errors: bad-number, no-such-guide.

/// Adds a guide after the others.
Result<Document> addGuide(const Document &document, Guide guide);
/// Moves a guide to another co-ordinate.
Result<Document> moveGuide(const Document &document, std::size_t index, double at);
Result<Document> removeGuide(const Document &document, std::size_t index);

} // namespace forefront
