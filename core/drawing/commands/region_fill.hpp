#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

namespace forefront {

/// Makes the face at p a region: replaces the markers in it by one with the tag at p; a maximum area and a size are
/// kept. Where segments cross, the faces are those between the pieces into which a repair would split them. Errors:
/// region-marker-outside (p is outside the domain or on a line), bad-tag, out-of-range.
Result<Document> fillRegion(const Document &document, Vec2 at, std::int32_t tag);

} // namespace forefront
