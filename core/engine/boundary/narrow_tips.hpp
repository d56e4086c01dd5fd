#pragma once

#include "core/engine/boundary/curve_cuts.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// The end of a domain segment beside a tip of the domain that is too narrow to be worth dividing.
struct NarrowEnd {
    std::uint32_t segment = 0;
    bool atA = true;     ///< the tip is at DomainSegment::a, otherwise at DomainSegment::b
    double length = 0.0; ///< of the part beside the tip, as a distance from it
};

/// Finds the narrow tips of the domain, and returns both segments of each, ordered by segment.
///
/// A tip lies inside the domain between two segments that meet at less than 20 degrees, or the curves that these
/// follow, with nothing but the outside beyond them. It is narrow as far from the corner as its sides are closer to
/// each other than 1/4 of the spacing and a curve can be followed by one piece: nodes there would add thin elements,
/// and none of them would be better for it.
///
/// `left` and `right` are the regions beside each segment, or kOutside; `curves` are the curves of the domain, or null.
std::vector<NarrowEnd> findNarrowEnds(const Domain &domain, const SpacingField &spacing,
                                      std::span<const std::uint32_t> left, std::span<const std::uint32_t> right,
                                      const CurveCuts *curves);

} // namespace forefront
