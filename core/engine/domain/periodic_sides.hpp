#pragma once

#include "core/engine/base/ids.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/domain/periodic.hpp"
#include "core/engine/domain/segment_elements.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// The segment that a segment of a periodic part is tied to.
struct PeriodicMate {
    std::uint32_t segment = kNoIndex; ///< kNoIndex: none
    std::uint32_t link = 0;           ///< index into PeriodicSides::links
    bool follows = false;             ///< it belongs to the second part, the image of the first
    bool reversed = false;            ///< its first node is tied to the second node of the other
};

/// The periodic parts of a domain, segment by segment.
struct PeriodicSides {
    std::vector<PeriodicLink> links;
    std::vector<PeriodicMate> mates; ///< per segment of the domain; empty without links

    bool ties(std::uint32_t segment) const { return !mates.empty() && mates[segment].segment != kNoIndex; }
};

/// Finds the motion that takes each first part to its second part: a translation if there is one, otherwise a rotation.
/// Each node of the first part must have its image among the nodes of the second, and each segment, with the domain on
/// the other side; curves must be images too. `faces`: those of the valid domain. `elements`: numbers of elements along
/// lines; where the second part has any, the first must have the same.
///
/// Errors: unknown-boundary, repeated-periodic, periodic-inside (a part has the domain on both sides or on none),
/// periodic-sides (the parts are not images, with the place of a node or segment without one), periodic-elements.
Result<PeriodicSides> findPeriodicSides(std::span<const PeriodicSpec> specs, const Domain &domain,
                                        const DomainFaces &faces, SegmentElements elements);

} // namespace forefront
