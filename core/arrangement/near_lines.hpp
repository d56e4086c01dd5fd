#pragma once

#include "core/domain/domain.hpp"

#include <cstddef>

namespace forefront {

/// The lines of a domain that nearly follow its boundary, so that the mesh needs very many elements between them.
/// Lengths are in domain units.
struct NearLines {
    std::size_t count = 0;   ///< number of segments
    double nearest = 0.0;    ///< their minimum distance from the boundary
    Vec2 first;              ///< the middle of the first of them
    std::size_t segment = 0; ///< the first of them
};

/// Finds the constraint segments whose middle is within 1/64 of their length of the boundary.
NearLines findNearLines(const Domain &domain);

} // namespace forefront
