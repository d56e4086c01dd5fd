#pragma once

#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <string>

namespace forefront {

struct Domain;

/// Returns a spacing with every element size multiplied by `factor` (> 0), areas by its square; numbers of elements per
/// turn and across narrow places are divided by it. The minimum, gradations, growths and numbers of elements along
/// segments stay, and so does the maximum, a limit. Only an automatic spacing has no size of its own: its upper bound
/// takes the factor, as the maximum, or as the size where it has to exceed what automatic spacing allows in `domain`.
SpacingSpec scaledSizes(SpacingSpec spacing, double factor, const Domain &domain);

/// Returns an expression for `factor` times another one. A factor that an earlier call put in front takes up the new
/// one.
std::string scaledExpression(const std::string &expression, double factor);

/// Returns which parts of a spacing keep their sizes whatever scaledSizes() does, such as "the minimum spacing 0.5 and
/// boundary lengths"; empty if there are none.
std::string unscaledSizes(const SpacingSpec &spacing);

} // namespace forefront
