#pragma once

#include "core/drawing/sketch/linear_algebra.hpp"

#include <cstdint>

namespace forefront {

/// Moves unknowns to a place near by, at most half the spread away: always the same for a seed. Leaves them if the
/// spread is 0.
inline void scatter(SketchVector &x, std::uint64_t seed, double spread) {
    std::uint64_t state = seed * 0x9e3779b97f4a7c15ULL + 0x2545f4914f6cdd1dULL;
    for (int k = 0; k < x.size(); ++k) {
        state ^= state << 13; // xorshift
        state ^= state >> 7;
        state ^= state << 17;
        constexpr double kUnit = 1.0 / 9007199254740992.0; // 2^-53
        x[k] += spread * (static_cast<double>(state >> 11) * kUnit - 0.5);
    }
}

} // namespace forefront
