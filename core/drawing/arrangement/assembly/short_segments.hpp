#pragma once

#include "core/engine/domain/domain.hpp"

#include <cstddef>

namespace forefront {

/// Segments that are hardly meant, because their neighbours are far longer: the mesh needs very many elements around
/// them. Lengths are in domain units.
struct ShortSegments {
    std::size_t count = 0;
    double longest = 0.0;    ///< maximum length of them
    Vec2 first;              ///< the middle of the first of them
    std::size_t segment = 0; ///< the first of them
};

/// Finds the segments shorter than `limit` (domain units) and than a hundredth of every segment at their ends. A
/// segment that meets no other is not reported. O(n).
ShortSegments findShortSegments(const Domain &domain, double limit);

} // namespace forefront
