#pragma once

#include "core/engine/domain/curve_chains.hpp"
#include "core/engine/spacing/sites/site_set.hpp"

namespace forefront {

/// A domain segment with the positions of its ends.
struct PlacedSegment {
    Vec2 a;
    Vec2 b;
    std::uint32_t index = 0;  ///< into Domain::segments
    double wholeLength = 0.0; ///< its length, or the length of the entire curve if it is a chord
    bool besideCurve = false; ///< it is a chord of a curve or ends where one does
    double length() const { return distance(a, b); }
};

/// Returns true if squares of distances between such coordinates do not overflow.
bool isUsable(Vec2 p);

/// Returns the segments whose ends are valid, usable and distinct. The domain may be invalid.
std::vector<PlacedSegment> placedSegments(const Domain &domain);

/// Marks the segments that are chords of a curve or end in one, and sets `wholeLength` of the chords to the length of
/// the curve, so that the result does not depend on how finely the curve was flattened.
void applyCurveLengths(const Domain &domain, const CurveChains &chains, std::vector<PlacedSegment> &segments);

/// Returns the box of the domain's usable nodes: the unit square if there are none, widened if it has no extent.
Box2 spacingBox(const Domain &domain);

/// Drops the segments whose length never determines the spacing, because the demands of shorter neighbours, including
/// their growth, are smaller everywhere along it.
void dropDominated(const Domain &domain, double gradation, std::vector<PlacedSegment> &segments);

/// Adds one site per segment, with the segment's length as size, growing by `gradation`. Short segments get small
/// elements around them; long ones are divided near shorter ones.
void addBoundarySites(const Domain &domain, double minimum, double gradation, SiteSet &sites);

} // namespace forefront
