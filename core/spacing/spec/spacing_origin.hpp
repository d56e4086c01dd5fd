#pragma once

#include <cstdint>

namespace forefront {

/// The part of the specification that determines the spacing at a point.
enum class SpacingOrigin : std::uint8_t {
    Constant,
    Expression,
    Source,
    Paint,
    Background,
    Boundary,
    Region,
    Automatic,
    Minimum,
    Maximum,
    Gradation
};

} // namespace forefront
