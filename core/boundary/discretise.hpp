#pragma once

#include "core/base/api.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/domain/domain.hpp"
#include "core/spacing/spacing_field.hpp"

#include <cstdint>
#include <vector>

namespace FOREFRONT_API forefront {

inline constexpr std::uint32_t kOutside = 0xffffffffU;

/// An edge of the discretised boundary or of a constraint.
struct DiscreteSegment {
    std::uint32_t a = 0; ///< index into DiscreteDomain::nodes
    std::uint32_t b = 0;
    std::int32_t tag = 1;
    std::uint32_t leftRegion = kOutside;  ///< index into DiscreteDomain::regions of the face left of a->b, or kOutside
    std::uint32_t rightRegion = kOutside; ///< likewise on the right; never both kOutside
    std::uint32_t source = 0;             ///< index of the DomainSegment it came from
};

struct DiscreteRegion {
    std::int32_t tag = 1;
    double area = 0.0; ///< of the discretised face, in domain units squared
};

/// The domain as the front starts from: B. Simple, oriented, closed; behind the door of `validate`.
/// Nodes 0..k-1 are the domain's nodes in their order (also those on constraints and isolated points).
struct DiscreteDomain {
    std::vector<Vec2> nodes;
    std::vector<DiscreteSegment> segments;
    std::vector<ConstraintPoint> points; ///< nodes that the mesh must contain; those on segments are in it anyway
    std::vector<DiscreteRegion> regions; ///< every connected face inside the domain
    std::map<std::int32_t, std::string> boundaryNames;
    std::map<std::int32_t, std::string> regionNames;
    /// What estimateElements() says with the spacing that it was discretised for; 0: not asked yet.
    double estimatedElements = 0.0;

    double area() const; ///< sum over regions
    Box2 bounds() const;
};

/// Cuts the segments of a validated domain so that their lengths follow the spacing (number of pieces from ∫ds/ρ, nodes
/// at equal fractions of that integral), or keeps them exactly as given; finds the faces and their regions. The same
/// result whatever the order or orientation of loops in the sense of geometry; deterministic. Errors: cancelled; more
/// nodes than can be held.
Result<DiscreteDomain> discretise(const Domain &domain, const SpacingField &spacing, bool keepBoundary,
                                  const Progress &progress = {});

} // namespace forefront
