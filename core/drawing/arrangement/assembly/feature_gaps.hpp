#pragma once

#include "core/engine/domain/domain.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace forefront {

/// The places of the boundary that nearly touch another feature, as along the border of two districts that have been
/// digitised twice. Lengths are in domain units.
struct FeatureGaps {
    std::size_t count = 0;   ///< number of places
    double widest = 0.0;     ///< maximum width
    Vec2 first;              ///< the first of the places
    std::size_t segment = 0; ///< a segment at that place
};

/// Finds the boundary nodes within `limit` (domain units) of another feature, and nodes and middles of segments within
/// ten times that where the gap is narrow for the length of its sides; except beside nodes where features meet: a gap
/// ends there in a corner, which is narrow, too. `features` gives, per domain segment, the feature that it bounds, or
/// kNoIndex if that is unknown. O(n log n).
FeatureGaps findFeatureGaps(const Domain &domain, std::span<const std::uint32_t> features, double limit);

} // namespace forefront
