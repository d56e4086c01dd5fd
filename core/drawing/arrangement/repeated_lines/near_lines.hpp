#pragma once

#include "core/engine/domain/domain.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace forefront {

/// The lines of a domain that nearly follow its boundary, so that the mesh needs very many elements between them.
/// Lengths are in domain units.
struct NearLines {
    std::size_t count = 0;   ///< number of segments
    double nearest = 0.0;    ///< their minimum distance from the boundary
    Vec2 first;              ///< the middle of the first of them
    std::size_t segment = 0; ///< the first of them
};

/// Finds the segments of lines whose middle is within 1/64 of their length of the boundary. `isLine`: per segment, 1 if
/// it belongs to a line; the others are boundary segments or borders of regions.
NearLines findNearLines(const Domain &domain, std::span<const std::uint8_t> isLine);

} // namespace forefront
