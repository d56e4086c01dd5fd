#pragma once

#include "core/engine/boundary/discretise.hpp"

#include <cstdint>
#include <optional>

namespace forefront {

/// Returns the first node of a boundary around which the faces on the two sides of some sector between segments are not
/// the same, so that no front can start there; nothing if there is none. O(n log n).
std::optional<std::uint32_t> unmatchedSector(const DiscreteDomain &boundary);

} // namespace forefront
