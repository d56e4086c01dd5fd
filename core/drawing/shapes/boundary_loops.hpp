#pragma once

#include "core/engine/domain/domain.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace forefront {

/// A closed loop of boundary segments of a domain.
struct BoundaryLoop {
    std::vector<std::uint32_t> nodes;    ///< in order, the first not repeated
    std::vector<std::uint32_t> segments; ///< segment k joins nodes k and k + 1
};

/// Returns the loops around the faces inside an even-odd domain, with the inside on the left: outlines
/// counter-clockwise, holes clockwise. Where faces touch at a node, each has a separate loop. Loops come in the order
/// of their first segments. Returns std::nullopt if segments cross or the boundary is not closed.
std::optional<std::vector<BoundaryLoop>> boundaryLoops(const Domain &domain);

} // namespace forefront
