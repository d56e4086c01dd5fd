#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/domain/mapped_spec.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// A face of a domain that is filled by rows of elements.
struct TransfiniteFace {
    std::uint32_t region = 0; ///< index into DiscreteDomain::regions
    std::uint32_t face = 0;   ///< index into the faces of the domain
    bool quads = true;        ///< its elements are quadrilaterals, else triangles
    std::vector<std::uint32_t>
        corners; ///< 3 or 4 nodes of the domain, counter-clockwise; of 3, the rows meet at the first
    /// Segments of the domain from each corner to the next, in order.
    std::vector<std::vector<std::uint32_t>> sides;
};

/// Finds the faces of the mapped regions of a valid domain, with their corners. Without given corners, the corners are
/// the nodes with interior angles below 150 degrees: 3 or 4 of them, or the 4 sharpest ones if these are sharper than
/// the others by 10 degrees or more. Of 3, the sharpest one comes first. `faces`: of the domain.
///
/// Errors, with their places: unknown-region (no face has the tag), repeated-mapped (a region is given twice),
/// mapped-outline (a face has holes, or lines or points inside, or touches itself), mapped-corners (the corners are
/// not 3 or 4, a given one is not a node of a face, or it lies inside a curve).
Result<std::vector<TransfiniteFace>> findMappedFaces(std::span<const MappedSpec> specs, const Domain &domain,
                                                     const DomainFaces &faces);

/// The outline of a face of a region that is to be filled by rows, with the nodes that can be its corners.
struct MappedOutline {
    std::vector<Vec2> nodes;            ///< counter-clockwise
    std::vector<std::uint32_t> able;    ///< nodes that can be corners, since they do not lie inside a curve, ascending
    std::vector<double> angles;         ///< interior angles at these, degrees
    std::vector<std::uint32_t> corners; ///< as findMappedFaces() has them; empty: it refuses the face
};

/// Returns the outlines of the faces of a region of a valid domain, mapped or not; faces with holes, or with lines or
/// points inside, are left out. `faces`: of the domain.
std::vector<MappedOutline> mappedOutlines(const MappedSpec &spec, const Domain &domain, const DomainFaces &faces);

} // namespace forefront
