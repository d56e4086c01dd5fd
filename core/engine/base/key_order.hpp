#pragma once

#include "core/engine/base/ids.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// Returns a key that orders numbers as `<` does. Zero and minus zero have the same key; NaN is not allowed.
inline std::uint64_t sortKey(double number) {
    constexpr std::uint64_t kSign = std::uint64_t{1} << 63U;
    const auto bits = std::bit_cast<std::uint64_t>(number + 0.0); // -0 + 0 is 0
    return (bits & kSign) != 0 ? ~bits : bits | kSign;
}

/// Returns a key that orders pairs by their first number, then by the second.
constexpr std::uint64_t pairKey(std::uint32_t first, std::uint32_t second) {
    return static_cast<std::uint64_t>(first) << 32U | second;
}
constexpr std::uint64_t pairKey(NodeId first, NodeId second) {
    return pairKey(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(second));
}

/// Returns the two numbers of such a key.
inline std::array<std::uint32_t, 2> pairOf(std::uint64_t key) {
    return {static_cast<std::uint32_t>(key >> 32U), static_cast<std::uint32_t>(key)};
}

/// Returns the indices of the keys in ascending order of the keys; equal keys stay in their order. There are fewer than
/// 2³² keys. A radix sort by the upper bits that vary, which avoids the mispredicted branches of comparisons; it takes
/// time proportional to their number unless many keys differ only in the bits below.
std::vector<std::uint32_t> orderByKeys(std::span<const std::uint64_t> keys);

} // namespace forefront
