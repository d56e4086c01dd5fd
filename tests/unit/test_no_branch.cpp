#include "core/engine/base/no_branch.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace forefront;

TEST_CASE("Limits without branches: the same values as std::max and std::clamp") {
    using Limits = std::numeric_limits<double>;
    for (const double size : {0.0, Limits::denorm_min(), Limits::min(), 0.3, std::nextafter(1.0, 0.0), 1.0,
                              std::nextafter(1.0, 2.0), 7.5, Limits::max(), Limits::infinity()}) {
        for (const double value : {size, -size}) {
            CAPTURE(value);
            CHECK(notNegative(value) == std::max(value, 0.0));
            CHECK(clampedToUnit(value) == std::clamp(value, 0.0, 1.0));
            CHECK_FALSE(std::signbit(notNegative(value)));
        }
    }
}
