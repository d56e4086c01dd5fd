#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/inside_test.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace forefront {

/// Limits for values that a formula or function gives at places where it was not probed.
struct ProbeLimits {
    double floor = 0.0;   ///< 1e-9 of the box's diagonal, or the given minimum
    double ceiling = 0.0; ///< 1000 times the box's diagonal, or the given maximum

    static ProbeLimits of(const SpacingSpec &spec, const Box2 &box);
    /// Clamps a value to the limits; NaN becomes the ceiling.
    double clamped(double value) const {
        const double low = value < floor ? floor : value;
        return low <= ceiling ? low : ceiling;
    }
};

inline constexpr int kProbes = 64; ///< intervals of the probing grid along each side

/// Returns the points where a formula or function must give a size: the domain's nodes, and the points of a 65 x 65
/// grid over its box that are inside; all of them if `inside` is null, because the inside is unknown.
std::vector<Vec2> probePlaces(const Domain &domain, const InsideTest *inside, const Box2 &box);

/// Returns the fault of the first value that is no size: NaN, a value <= 0 without a minimum, or infinity without a
/// maximum. `what`: the part, such as "spacing expression"; `advice`: how to fix it.
Diagnostics probeFaults(std::span<const Vec2> places, std::span<const double> values, const SpacingSpec &spec,
                        const char *code, std::string_view what, std::string_view advice);

} // namespace forefront
