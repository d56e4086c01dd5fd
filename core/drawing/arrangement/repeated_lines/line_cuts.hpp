#pragma once

#include "core/drawing/arrangement/repeated_lines/outline_search.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace forefront {

/// A part of an edge that is dropped.
struct LineCut {
    std::uint32_t edge = 0;
    double from = 0.0, to = 1.0;        ///< fractions of the way from its end `a`
    std::optional<Vec2> before, beyond; ///< places on outlines where the parts before and beyond end, if not at a node
    double distance = 0.0;              ///< from the outlines
};

/// Returns loose lines without the given parts. Where a line continues from a node at which others end, and `movable`
/// (per node) allows it, their ends move to the outline nearby.
RepeatedOutlines withoutCuts(std::vector<LineCut> cuts, std::span<const Vec2> nodes, std::span<const PlaneEdge> edges,
                             std::span<const BesideEdge> about, std::span<const std::uint8_t> movable,
                             const OutlineSearch &outlines);

} // namespace forefront
