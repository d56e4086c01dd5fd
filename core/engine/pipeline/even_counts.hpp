#pragma once

#include "core/engine/boundary/discretise.hpp"
#include "core/engine/mesher/options.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Returns the numbers of elements along the segments of the domain that must stay, see EvenRules. Those along periodic
/// parts do, since a node added to one of them would have no partner.
std::vector<std::uint32_t> countsWithPeriodic(const MeshingJob &job, const DiscreteDomain &boundary);

} // namespace forefront
