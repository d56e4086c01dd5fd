#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/engine/geometry/curve.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace FOREFRONT_API forefront {

/// The purpose of a domain segment.
enum class SegmentRole : std::uint8_t {
    Boundary,  ///< separates inside from outside
    Constraint ///< must be in the mesh; may divide the domain into regions or end freely inside
};

/// The rule that decides which faces between the segments are inside the domain.
enum class InsideRule : std::uint8_t {
    EvenOdd, ///< inside where a ray to infinity crosses an odd number of Boundary segments; the order and orientation
             ///< of loops do not matter
    HoleMarkers ///< every bounded face is inside except those that hold a hole marker (as in Triangle's .poly)
};

struct DomainSegment {
    std::uint32_t a = 0; ///< index into Domain::nodes
    std::uint32_t b = 0;
    std::int32_t tag = 1; ///< >= 1
    SegmentRole role = SegmentRole::Boundary;
    /// The part of a curve that the segment is a chord of, from a to b. Straight segments follow none.
    CurveStretch stretch = {};
};

/// Marks the face that contains a point as a region.
struct RegionMarker {
    Vec2 at;              ///< any point inside the face
    std::int32_t tag = 1; ///< >= 1

    friend bool operator==(const RegionMarker &, const RegionMarker &) = default;
};

struct ConstraintPoint {
    std::uint32_t node = 0; ///< index into Domain::nodes
    std::int32_t tag = 1;   ///< >= 1
};

/// A planar domain as given: segments over nodes in any order, with holes, islands, constraints, tags and names. It
/// holds no element sizes: all of them are in SpacingSpec. Nothing about it can be relied on until `validate` has
/// accepted it.
///
/// Curved parts are given twice: as straight segments, which decide what is inside, and as the curves that these are
/// chords of, which the mesh follows. The chords must be fine enough that nothing lies between them and their curves;
/// where something does, the mesh follows the chords.
struct Domain {
    std::vector<Vec2> nodes;
    std::vector<DomainSegment> segments;
    std::vector<ConstraintPoint> points;
    std::vector<Vec2> holeMarkers;
    std::vector<RegionMarker> regionMarkers;
    InsideRule insideRule = InsideRule::EvenOdd;
    std::vector<Curve> curves; ///< exact curves that segments follow
    /// Maximum distance of a curve from its edges in the mesh, in domain units; 0: 1/2000 of the domain's diagonal.
    double curveTolerance = 0.0;
    /// Names of boundary parts and regions by tag; a tag without an entry is named "boundary_TAG" or "region_TAG".
    std::map<std::int32_t, std::string> boundaryNames;
    std::map<std::int32_t, std::string> regionNames;

    /// Returns the box of all nodes with finite coordinates.
    Box2 bounds() const;
};

/// Returns the name of a boundary tag: the entry in `names`, or "boundary_TAG".
std::string boundaryName(const std::map<std::int32_t, std::string> &names, std::int32_t tag);
/// Returns the name of a region tag: the entry in `names`, or "region_TAG".
std::string regionName(const std::map<std::int32_t, std::string> &names, std::int32_t tag);

} // namespace forefront
