#pragma once

#include "core/base/result.hpp"
#include "core/edit/document.hpp"

namespace forefront {

/// Makes the face at p a region: markers that lie in the face go, and one with the tag is put at p. Refused with
/// "region-marker-outside" where p is outside of the domain or on a line, "bad-tag", and "not-possible" while segments
/// cross, for then there are no faces to fill.
Result<Document> fillRegion(const Document &document, Vec2 at, std::int32_t tag);

} // namespace forefront
