#pragma once

#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/segment_elements.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace forefront {

/// Consecutive segments that follow one curve through nodes where nothing else meets.
struct CurveChain {
    std::uint32_t curve = 0;
    std::uint32_t start = 0; ///< node at the parameter t0
    std::uint32_t end = 0;
    double t0 = 0.0;
    double t1 = 1.0;
    std::vector<std::uint32_t> segments; ///< in the order of the parameter, which increases
};

struct CurveChains {
    std::vector<CurveChain> list;
    std::vector<std::uint32_t> ofSegment; ///< per segment: its chain, or kNoIndex
};

/// Returns how far a curve of the domain may be from its edges in the mesh, in domain units: Domain::curveTolerance or
/// its default.
double chordTolerance(const Domain &domain);

/// Returns the number of elements that a chain must have, at least 3 for a loop; 0: as the spacing asks. Chains of one
/// curve share its number by their lengths.
std::uint32_t elementsAlong(const Domain &domain, const CurveChain &chain, SegmentElements elements);

/// Returns the bias of the elements along the curve of a chain, in the direction of its parameter.
ElementBias biasAlong(const Domain &domain, const CurveChain &chain, SegmentElements elements);

/// Returns how many elements of its curve are before the start and before the end of a chain. `places`: of those along
/// the curve, see elementPlaces().
std::pair<double, double> elementsOfChain(const Domain &domain, const CurveChain &chain,
                                          const std::vector<double> &places);

/// Finds the chains of a domain, which need not be valid. Segments whose ends are nowhere near their curve are left
/// out. An inner node of a chain is on the curve, belongs to no other segment and is no constraint point; all segments
/// of a chain have one tag and role.
CurveChains curveChains(const Domain &domain);

} // namespace forefront
