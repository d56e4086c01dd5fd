#pragma once

#include <bit>
#include <cstdint>

namespace forefront {

/// Number of mantissa bits that orderKey() drops: 30 of 52 stay, so that a class of equal numbers is about 1e-9 wide.
inline constexpr unsigned kTieBits = 22;

/// Relative distance from a limit within which a number counts as equal to it.
inline constexpr double kTieWidth = 1e-9;

/// Returns a key that orders finite numbers as they are, but is the same for numbers that differ only by rounding.
///
/// The classic method compares lengths and scores by such keys. Numbers that are equal by construction differ in their
/// last bits, and differently so where a drawing is shifted or scaled: compared exactly, they would decide on another
/// mesh. A comparison within a tolerance would not do, since "equal" must be transitive in a sort.
///
/// Numbers near the border of two classes can still fall on either side of it. Rounding to nearest keeps simple numbers
/// away from there: a border is the middle between two numbers of 30 bits, so that whole numbers, halves and other
/// short binary fractions lie in the middle of their class. A fraction p/q with odd q is an odd multiple of 1/(2q) of a
/// class away from each border, or more: for tenths and sevenths at least 1/18, 6e-11 in relative terms, while the
/// rounding of co-ordinates leaves errors of 1e-16 to 1e-13. Irrational numbers, such as heights of triangles, come as
/// close with a probability of about 1e-4.
///
/// `droppedBits`: how many bits of the mantissa to round off; 0 compares exactly.
inline std::int64_t orderKey(double value, unsigned droppedBits = kTieBits) {
    constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
    const std::uint64_t half = (std::uint64_t{1} << droppedBits) >> 1;
    const auto key =
        static_cast<std::int64_t>(((std::bit_cast<std::uint64_t>(value) & ~kSign) + half) >> droppedBits);
    return value < 0.0 ? -key : key;
}

} // namespace forefront
