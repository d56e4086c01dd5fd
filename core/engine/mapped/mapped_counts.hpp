#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/boundary/discretise.hpp"
#include "core/engine/domain/periodic_sides.hpp"
#include "core/engine/mapped/mapped_faces.hpp"
#include "core/engine/strips/widened_domain.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// What the numbers of elements along the sides of mapped faces depend on. Refers to its parts.
struct MappedDivision {
    const Domain &domain;
    std::span<const TransfiniteFace> faces;
    std::span<const StripFace> strips;
    SegmentElements given;         ///< numbers of elements that must stay
    const PeriodicSides &periodic; ///< lines that are divided alike
    bool keepBoundary = false;     ///< no segment may be divided in another way
    double maxElements = 0.0;      ///< limit on the elements of the mesh
};

/// Numbers of elements of the lines and curves of a domain, and the domain that they are for: a copy in which each part
/// of a curve is a curve of its own, so that it can have its own number.
struct MappedNumbers {
    Domain domain;
    std::vector<std::uint32_t> elements; ///< per segment: of its line or curve; 0: as the spacing asks
    std::vector<ElementBias> biases;     ///< per segment; none where the number was not given
    bool changed = false;                ///< a number differs from that of the boundary
    /// Elements of mapped faces, and of strips. Where their sum exceeds the limit, the sides need not be equal yet, and
    /// `elements` are not set.
    double inFaces = 0.0;
    double inStrips = 0.0;
};

/// Makes the opposite sides of mapped faces and of strips equal in number: where they differ, the side with fewer
/// elements gets more, each time the line or curve with the longest elements relative to the spacing. Sides that
/// neighbouring faces share carry the change on. `boundary`: the domain as the spacing divides it. Errors, with the
/// place of a side: mapped-sides (no line of a side may get more elements, the numbers grow without end, or no number
/// of a whole curve gives a part of it as many as it needs), cancelled.
Result<MappedNumbers> equalNumbers(const MappedDivision &division, const DiscreteDomain &boundary,
                                   const Progress &progress = {});

} // namespace forefront
