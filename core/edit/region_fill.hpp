#pragma once

#include "core/base/result.hpp"
#include "core/edit/document.hpp"

namespace forefront {

/// Makes the face at p a region: replaces the markers in it by one with the tag at p; a maximum area is kept. Errors:
/// region-marker-outside (p is outside the domain or on a line), bad-tag, not-possible (segments cross, so there are no
/// faces).
Result<Document> fillRegion(const Document &document, Vec2 at, std::int32_t tag);

} // namespace forefront
