#pragma once

#include "core/drawing/arrangement/arrangement.hpp"
#include "core/drawing/arrangement/curves/joined_lines.hpp"
#include "core/drawing/arrangement/repeated_lines/beside_outlines.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// A drawing without the lines that repeat outlines.
struct ReducedDrawing {
    ArrangementInput input;            ///< no line may be dropped for that reason again
    std::vector<std::uint32_t> source; ///< per piece: the piece that it is part of
};

/// Drops the parts of lines that repeat outlines, and moves the ends of the rest to the outlines: a piece along a
/// straight edge as a whole, one along a curve as far as twice its reach from there, so that the rest follows its
/// curve. The outlines do not change, and get no nodes from the dropped parts. `joined`: the pieces; `about`: per edge.
ReducedDrawing withoutRepeats(const ArrangementInput &input, const JoinedLines &joined,
                              const RepeatedOutlines &repeated, std::span<const BesideEdge> about);

} // namespace forefront
