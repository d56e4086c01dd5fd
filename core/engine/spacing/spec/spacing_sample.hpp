#pragma once

#include "core/engine/base/api.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace FOREFRONT_API forefront {

/// The part of the specification that determines the spacing at a point.
enum class SpacingOrigin : std::uint8_t {
    Constant,
    Expression,
    Function,
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

/// The smallest size at a point that is set by another part of the specification than the one in effect.
struct SpacingRunnerUp {
    double rho = 0.0;     ///< at least the spacing in effect
    std::string describe; ///< as in SpacingSample
};

/// The spacing at a point and the part of the specification that set it.
struct SpacingSample {
    double rho = 0.0;
    SpacingOrigin origin = SpacingOrigin::Constant;
    /// Index into SpacingSpec::sources, the domain's segments or PlacedSizes::regions, by origin.
    std::uint32_t source = 0;
    std::string describe; ///< for the inspector, such as "source 'pier head'"; filled by sample() only
    std::optional<SpacingRunnerUp> runnerUp = {}; ///< nothing if no other part sets a size there
};

} // namespace forefront
