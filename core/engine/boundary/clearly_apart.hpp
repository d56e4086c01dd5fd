#pragma once

#include "core/engine/boundary/discretise.hpp"

namespace forefront {

/// Returns true if rounding cannot have made the pieces of a valid domain meet, or pushed anything to another side:
/// the segments that are divided, all of them straight, are farther from everything than rounding moves a node. Half
/// the time of the exact check on a map, where most segments are divided. The exact check has to decide where this
/// returns false: where parts are closer, or long and close together.
bool areClearlyApart(const Domain &domain, const DiscreteDomain &discrete);

} // namespace forefront
