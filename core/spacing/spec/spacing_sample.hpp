#pragma once

#include "core/base/api.hpp"

#include <cstdint>
#include <string>

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

/// The spacing at a point and the part of the specification that set it.
struct SpacingSample {
    double rho = 0.0;
    SpacingOrigin origin = SpacingOrigin::Constant;
    std::uint32_t source = 0; ///< index into SpacingSpec::sources, the domain's segments or its markers, by origin
    std::string describe;     ///< for the inspector, such as "source 'pier head'"; filled by sample() only
};

} // namespace forefront
