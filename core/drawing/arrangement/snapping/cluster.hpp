#pragma once

#include "core/engine/base/vec2.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// Groups places around leaders. Leaders lie farther than `radius` from one another, and every place is at most
/// `radius` from its leader, the nearest one. Places are processed in the order of x, then y, with the `preferred` ones
/// first, so the groups depend on the set of places alone. Places must be distinct. O(n log n). Returns the leader of
/// each place, itself for leaders.
std::vector<std::uint32_t> clusterPlaces(std::span<const Vec2> places, std::span<const std::uint8_t> preferred,
                                         double radius);

} // namespace forefront
