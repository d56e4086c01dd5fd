#pragma once

#include "core/engine/geometry/morton.hpp"

#include <array>
#include <cstdint>

namespace forefront {

namespace hilbert {

/// The curve enters a square in one of four ways. The tables give, for each way and each quarter in Morton order, the
/// place of the quarter along the curve and the way into the quarter.
inline constexpr std::uint8_t kPlace[4][4] = {{0, 3, 1, 2}, {0, 1, 3, 2}, {2, 3, 1, 0}, {2, 1, 3, 0}};
inline constexpr std::uint8_t kWay[4][4] = {{1, 2, 0, 0}, {0, 1, 3, 1}, {2, 0, 2, 3}, {3, 3, 1, 2}};

struct Step {
    std::uint8_t places, way;
};

/// Four levels of quarters at once: per way into the square, and per Morton code of a part.
inline constexpr std::array<std::array<Step, 256>, 4> kSteps = [] {
    std::array<std::array<Step, 256>, 4> steps{};
    for (unsigned from = 0; from < 4; ++from) {
        for (unsigned code = 0; code < 256; ++code) {
            unsigned way = from, places = 0;
            for (unsigned level = 4; level-- > 0;) {
                const unsigned quarter = (code >> (2 * level)) & 3U;
                places = 4 * places + kPlace[way][quarter];
                way = kWay[way][quarter];
            }
            steps[from][code] = {static_cast<std::uint8_t>(places), static_cast<std::uint8_t>(way)};
        }
    }
    return steps;
}();

} // namespace hilbert

/// Returns the number along a Hilbert curve of the cell with a Morton code: unlike on a Morton curve, cells that follow
/// each other share a side, so that groups of them fill smaller boxes.
constexpr std::uint32_t hilbertCode(std::uint32_t morton) {
    std::uint32_t code = 0;
    unsigned way = 0;
    for (int shift = 24; shift >= 0; shift -= 8) {
        const hilbert::Step step = hilbert::kSteps[way][(morton >> shift) & 0xffU];
        code = code << 8U | step.places;
        way = step.way;
    }
    return code;
}

} // namespace forefront
