#pragma once

#include "core/base/api.hpp"

#include <cstdint>

namespace FOREFRONT_API forefront {

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
