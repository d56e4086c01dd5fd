#pragma once

#include <cmath>

namespace forefront {

/// A neighbour of a node that may move, relative to it.
struct Spoke {
    float x, y;
    float rest; ///< target length of the edge to it
};

/// The sums Σ w·(p* − p) and Σ w, and the pull of the springs; see NodeSmoother.
struct Pull {
    float x = 0.0F, y = 0.0F, weight = 0.0F, springX = 0.0F, springY = 0.0F;

    /// Adds the element between a spoke and the next, and the spring of the spoke.
    void add(const Spoke &spoke, const Spoke &next) {
        constexpr float kHeight = 0.8660254F; // of the equilateral triangle
        const float ax = next.x - spoke.x, ay = next.y - spoke.y;
        const float side = ax * ax + ay * ay; // squared
        const float length = std::sqrt(spoke.x * spoke.x + spoke.y * spoke.y);
        const float inverse = 1.0F / (side * length); // one division for two
        const float w = inverse * length;
        x += w * (0.5F * (spoke.x + next.x) - kHeight * ay);
        y += w * (0.5F * (spoke.y + next.y) + kHeight * ax);
        weight += w;
        const float spring = 1.0F - spoke.rest * (inverse * side);
        springX += spring * spoke.x;
        springY += spring * spoke.y;
    }
};

} // namespace forefront
