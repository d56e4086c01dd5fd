#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/domain/segment_elements.hpp"
#include "core/engine/spacing/sites/size_site.hpp"
#include "core/engine/strips/strip_spec.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// Two lines or curves on the sides of a strip, opposite each other, which get equal numbers of elements.
struct StripPiece {
    std::vector<std::uint32_t> left, right; ///< segments, each from a to b along the strip
};

/// A strip as a face of a domain.
struct StripFace {
    std::int32_t tag = 1; ///< of the line
    std::uint32_t rows = 1;
    LayerCells cells = LayerCells::Quads;
    bool closed = false;                    ///< it has no ends
    std::vector<StripPiece> pieces;         ///< in order along the strip
    std::array<std::uint32_t, 4> corners{}; ///< nodes: right and left at the start, right and left at the end
    std::uint32_t face = 0;                 ///< index into the faces of the domain
    std::uint32_t region = 0;               ///< index into DiscreteDomain::regions
};

/// A domain whose strips are faces.
struct WidenedDomain {
    Domain domain;
    DomainFaces faces;
    std::vector<std::uint32_t> elements; ///< per segment: number of elements, see SegmentElements
    std::vector<ElementBias> biases;     ///< per segment
    std::vector<StripFace> strips;
    std::vector<SizeSite> ends; ///< edges of ends that the front meets, with their lengths as sizes
};

/// Makes faces of the lines of strips: each line is replaced by two parallels, with mitres where it bends, and by ends
/// across. An end inside the domain is flat; on the boundary, or on another line, the strip follows that line. Nodes of
/// the line are left out.
///
/// `specs`: checked, see checkStrips(). `elements`: of the domain. Errors, with their places: those of stripLines();
/// strip-bend (a corner is sharper than the limit of its mitre, or a part between corners is too short for the width);
/// strip-end (a line is met too obliquely, it is shorter than the strip is wide, has a number of elements of its own,
/// or needs more rows); strip-room (a strip meets itself, another strip or another line, or something lies inside).
Result<WidenedDomain> widenedDomain(const Domain &domain, std::span<const StripSpec> specs,
                                    const SegmentElements &elements, double growth);

} // namespace forefront
