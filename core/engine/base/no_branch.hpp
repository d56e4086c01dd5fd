#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

/// Limits of numbers for hot loops whose data are in no order. For std::max and std::min with a constant, compilers
/// emit branches, which are mispredicted there at a cost of several evaluations; these work on the bits instead. Not
/// for NaN.
namespace forefront {

static_assert(sizeof(double) == sizeof(std::int64_t));

/// Returns max(value, 0).
inline double notNegative(double value) {
    const auto bits = std::bit_cast<std::int64_t>(value);
    return std::bit_cast<double>(bits & ~(bits >> 63)); // all bits are cleared if that of the sign is set
}

/// Returns `value` limited to [0, 1].
inline double clampedToUnit(double value) {
    // The bits of numbers that are not negative are in the order of the numbers.
    const auto bits = std::bit_cast<std::int64_t>(notNegative(value));
    return std::bit_cast<double>(std::min(bits, std::bit_cast<std::int64_t>(1.0)));
}

} // namespace forefront
