#pragma once

#include "core/edit/document.hpp"

namespace forefront {

/// Returns true if two documents have the same shapes (ids included), markers, names, spacing, options and limits,
/// wherever those are in memory; `nextId` does not count.
bool sameContent(const Document &a, const Document &b);

} // namespace forefront
