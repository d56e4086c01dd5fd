#pragma once

#include "core/edit/document.hpp"

namespace forefront {

/// True if two documents say the same: shapes (deeply), markers, names, spacing (paint tile by tile), options. Ids
/// count; `nextId` does not.
bool sameContent(const Document &a, const Document &b);
bool sameContent(const SpacingSpec &a, const SpacingSpec &b);

} // namespace forefront
