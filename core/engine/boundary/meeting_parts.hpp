#pragma once

#include "core/engine/boundary/curve_cuts.hpp"
#include "core/engine/boundary/discretise.hpp"

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace forefront {

/// A division of a domain's segments into pieces, to be checked.
struct Division {
    const DiscreteDomain &discrete;
    const CurveCuts *curves;                    ///< null: all segments are straight
    std::span<const ChainPiece> pieces;         ///< per discrete segment, without a chain where straight; may be empty
    std::span<const std::uint32_t> pointRegion; ///< per isolated point: the region it belongs to
    std::span<const std::uint32_t> pointBelow;  ///< per isolated point: the domain segment directly below, or kNoIndex
};

/// The parts to divide again because their pieces meet other than at common ends, or lie on the wrong side.
struct MeetingParts {
    std::vector<std::uint32_t> segments; ///< straight segments of the domain, in order
    std::vector<ChainPiece> pieces;      ///< of curves

    bool none() const { return segments.empty() && pieces.empty(); }
};

/// Finds the parts whose pieces meet others, coincide in a node, or have pushed something to another region. Where a
/// curved piece meets a straight one, only the curved one has to change. Exact. Meaningless after a stop request.
MeetingParts findMeetingParts(const Division &division, const std::stop_token &stop);

} // namespace forefront
