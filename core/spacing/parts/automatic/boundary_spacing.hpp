#pragma once

#include "core/domain/domain.hpp"
#include "core/spacing/sites/site_set.hpp"

namespace forefront {

/// A segment of the domain with its ends looked up; only those with valid, finite, distinct ends are kept.
struct PlacedSegment {
    Vec2 a;
    Vec2 b;
    std::uint32_t index = 0; ///< into Domain::segments
    double length() const { return distance(a, b); }
};

/// True for coordinates whose squares of distances do not overflow.
bool isUsable(Vec2 p);

/// The usable segments of a domain that may not have been validated.
std::vector<PlacedSegment> placedSegments(const Domain &domain);

/// Box of the domain's finite nodes; the unit square where there are none; widened where it has no extent.
Box2 spacingBox(const Domain &domain);

/// Drops the segments whose own length is never the least demand: at both ends of such a segment a neighbour asks for
/// less, growth included, and so it does everywhere.
void dropDominated(const Domain &domain, double gradation, std::vector<PlacedSegment> &segments);

/// One site a segment, of the segment's length, growing by `gradation`: short segments draw small elements to them,
/// long ones are cut where shorter ones are near.
void addBoundarySites(const Domain &domain, double minimum, double gradation, SiteSet &sites);

} // namespace forefront
