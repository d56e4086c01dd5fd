#pragma once

#include "core/engine/base/ids.hpp"
#include "core/engine/base/vec2.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

namespace forefront {

/// The corners of a quadrilateral or, if the last one is kNoIndex, of a triangle, counter-clockwise. The first one is
/// kNoIndex where there is no element.
using QuadCell = std::array<std::uint32_t, 4>;

inline constexpr QuadCell kNoCell = {kNoIndex, kNoIndex, kNoIndex, kNoIndex};

inline bool isTriangle(const QuadCell &cell) {
    return cell[3] == kNoIndex;
}
inline bool isAlive(const QuadCell &cell) {
    return cell[0] != kNoIndex;
}
inline unsigned cornersOf(const QuadCell &cell) {
    return isTriangle(cell) ? 3 : 4;
}
/// Returns the number of the corner at a node; 4: none.
inline unsigned cornerAt(const QuadCell &cell, std::uint32_t node) {
    unsigned k = 0;
    while (k < 4 && cell[k] != node) {
        ++k;
    }
    return k;
}
/// Returns the corner after, or before, the corner k.
inline std::uint32_t nextCorner(const QuadCell &cell, unsigned k) {
    return cell[k + 1 == cornersOf(cell) ? 0 : k + 1];
}
inline std::uint32_t previousCorner(const QuadCell &cell, unsigned k) {
    return cell[k == 0 ? cornersOf(cell) - 1 : k - 1];
}

/// Returns the scaled Jacobian: the minimum over the corners of the sine of their angle, which is negative where the
/// angle exceeds 180 degrees; of triangles, times 2/√3.
inline double scaledJacobian(const QuadCell &cell, std::span<const Vec2> nodes) {
    const unsigned n = cornersOf(cell);
    std::array<Vec2, 4> side{};
    std::array<double, 4> length2{};
    for (unsigned k = 0; k < n; ++k) {
        side[k] = nodes[nextCorner(cell, k)] - nodes[cell[k]];
        length2[k] = lengthSquared(side[k]);
    }
    double minimum = 2.0;
    for (unsigned k = 0; k < n; ++k) {
        const unsigned j = k == 0 ? n - 1 : k - 1;
        const double product = length2[j] * length2[k];
        minimum = std::min(minimum, product > 0.0 ? cross(side[j], side[k]) / std::sqrt(product) : 0.0);
    }
    constexpr double kTriangle = 1.1547005383792515;
    return n == 3 ? kTriangle * minimum : minimum;
}

} // namespace forefront
