#pragma once

#include "core/drawing/arrangement/repeated_lines/outline_search.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// A part of a chain is dropped if its length is at least this many times its distance from outlines, and it ends where
/// the line leaves them at a slope of more than one in this many. The gap beside a shorter part needs few elements, and
/// lines that merely end on an outline at some angle are no repetition.
inline constexpr double kMinRunToDistance = 16.0;

/// An edge of a chain in the direction of the chain.
struct ChainEdge {
    std::uint32_t edge = 0;
    bool forward = true; ///< from its end `a` to its end `b`
};

/// A place on a chain.
struct OutlinePlace {
    std::size_t edge = 0; ///< index in the chain
    double part = 0.0;    ///< fraction of the way along that edge, in the direction of the chain
    Vec2 outline;         ///< the place on outlines near it
};

/// A part of a chain that repeats outlines.
struct ChainRun {
    OutlinePlace from;
    OutlinePlace to;
    double distance = 0.0; ///< maximum distance from the outlines
};

/// Returns the parts of a chain that repeat outlines, in its order.
std::vector<ChainRun> runsBesideOutlines(std::span<const ChainEdge> chain, std::span<const BesideEdge> about,
                                         const EdgeShapes &shapes, const OutlineSearch &outlines);

} // namespace forefront
