#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/periodic.hpp"
#include "core/engine/domain/segment_elements.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace FOREFRONT_API forefront {

struct DomainFaces;
struct PeriodicSides;

/// The region index that stands for the outside of the domain.
inline constexpr std::uint32_t kOutside = 0xffffffffU;

/// An edge of the discretised boundary or of a constraint.
struct DiscreteSegment {
    std::uint32_t a = 0; ///< index into DiscreteDomain::nodes
    std::uint32_t b = 0;
    std::int32_t tag = 1;
    std::uint32_t leftRegion = kOutside;  ///< index into DiscreteDomain::regions of the face left of a->b, or kOutside
    std::uint32_t rightRegion = kOutside; ///< the same for the right side; never both kOutside
    std::uint32_t source = 0;             ///< index of the DomainSegment it came from
};

/// A connected face inside the domain.
struct DiscreteRegion {
    std::int32_t tag = 1;
    double area = 0.0; ///< of the discretised face, in domain units squared
};

/// The discretised boundary B from which the front starts: simple, oriented and closed, since the domain was validated.
/// The first nodes are those of the domain in order, including those of constraints and isolated points, but without
/// those that only divided a curve into chords.
struct DiscreteDomain {
    std::vector<Vec2> nodes;
    std::vector<DiscreteSegment> segments;
    std::vector<Curve> curves; ///< the curves of the domain
    /// Per segment, the part of a curve that it is a chord of; empty if the domain has no curves.
    std::vector<CurveStretch> stretches;
    /// The segments of the domain that follow a curve but were taken as straight, because curves cross there.
    std::vector<std::uint32_t> straightened;
    std::vector<ConstraintPoint> points; ///< nodes that the mesh must contain besides segment ends
    std::size_t gradedNodes = 0;         ///< number of the last of `points` that have no tag, see addGradedNodes()
    std::vector<DiscreteRegion> regions; ///< every connected face inside the domain
    std::vector<PeriodicLink> periodic;  ///< parts that are divided alike
    std::map<std::int32_t, std::string> boundaryNames;
    std::map<std::int32_t, std::string> regionNames;
    /// Result of estimateElements() for the spacing it was discretised with; 0: not computed yet.
    double estimatedElements = 0.0;

    /// Returns the points that the mesh must contain, without those that only lead to the size asked for.
    std::span<const ConstraintPoint> taggedPoints() const {
        return std::span(points).first(points.size() - gradedNodes);
    }
    /// Returns the sum of the regions' areas.
    double area() const;
    Box2 bounds() const;
};

/// The treatment of tips of less than 20 degrees with only the outside beyond their sides, where they are narrower than
/// 1/4 of the spacing.
enum class NarrowTips : std::uint8_t {
    Divided, ///< divided like other parts
    Whole,   ///< left undivided: one long element instead of many thin ones
};

/// Divides the segments of a validated domain so that their lengths follow the spacing, or keeps them exactly as given,
/// and finds the faces and their regions. The number of pieces is taken from `elements`, or follows from ∫ds/ρ, with
/// nodes at equal fractions of the integral. Deterministic; the geometry does not depend on the order or orientation of
/// loops.
///
/// Segments that follow one curve through nodes where nothing else meets are divided as one, with every node on the
/// curve and at most Domain::curveTolerance between the curve and its edges. Pieces that meet others, or have others on
/// the wrong side, are halved until none does; where that does not help, because curves cross although their chords do
/// not, the chords are used unchanged.
///
/// `faces` are those that validate() found in this domain; without them, they are found again.
///
/// `periodic`: parts that are divided alike, at the finer spacing of both; null: none. Each node put on a second part
/// is, to the bit, the image of one on its first part. Nodes of the domain stay where they are.
///
/// Errors: cancelled, too-many-nodes, invalid-domain, periodic-sides (a curve and its image are crossed at different
/// places).
Result<DiscreteDomain> discretise(const Domain &domain, const SpacingField &spacing, bool keepBoundary,
                                  const Progress &progress = {}, const DomainFaces *faces = nullptr,
                                  NarrowTips narrowTips = NarrowTips::Divided, SegmentElements elements = {},
                                  const PeriodicSides *periodic = nullptr);

} // namespace forefront
