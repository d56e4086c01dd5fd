#pragma once

#include "core/base/result.hpp"
#include "core/edit/document.hpp"

namespace forefront {

/// Makes the face at p a region: the marker that lies in the face gets the tag, or a new one is put at p. Refused with
/// "region-marker-outside" where p is outside of the domain, "bad-tag".
Result<Document> fillRegion(const Document &document, Vec2 at, std::int32_t tag);

} // namespace forefront
