#pragma once

#include "core/base/vec2.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace forefront {

/// What a segment of the domain means.
enum class SegmentRole : std::uint8_t {
    Boundary,  ///< counts for inside and outside
    Constraint ///< must be in the mesh; may divide the domain into regions or end freely inside
};

/// How the faces cut out by the segments are told to be inside or outside.
enum class InsideRule : std::uint8_t {
    EvenOdd,    ///< inside where a ray to infinity crosses an odd number of Boundary segments (loops in any order,
                ///< orientation)
    HoleMarkers ///< every bounded face is inside but those that hold a hole marker (Triangle's .poly)
};

struct DomainSegment {
    std::uint32_t a = 0; ///< index into Domain::nodes
    std::uint32_t b = 0;
    std::int32_t tag = 1; ///< >= 1
    SegmentRole role = SegmentRole::Boundary;
};

struct RegionMarker {
    Vec2 at;              ///< any point inside the face
    std::int32_t tag = 1; ///< >= 1
};

struct ConstraintPoint {
    std::uint32_t node = 0; ///< index into Domain::nodes
    std::int32_t tag = 1;   ///< >= 1
};

/// A planar domain as given: an unordered set of segments over nodes, with holes, islands, constraints, tags and names.
/// Nothing is promised of it before `validate` has passed it.
struct Domain {
    std::vector<Vec2> nodes;
    std::vector<DomainSegment> segments;
    std::vector<ConstraintPoint> points;
    std::vector<Vec2> holeMarkers;
    std::vector<RegionMarker> regionMarkers;
    InsideRule insideRule = InsideRule::EvenOdd;
    /// Names of boundary parts and regions by tag; a tag without an entry is named "boundary_TAG" or "region_TAG".
    std::map<std::int32_t, std::string> boundaryNames;
    std::map<std::int32_t, std::string> regionNames;

    Box2 bounds() const; ///< of all nodes with finite coordinates
};

/// Name of a tag: the given one, or the default.
std::string boundaryName(const std::map<std::int32_t, std::string> &names, std::int32_t tag);
std::string regionName(const std::map<std::int32_t, std::string> &names, std::int32_t tag);

} // namespace forefront
