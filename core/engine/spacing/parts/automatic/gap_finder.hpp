#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/lazy_faces.hpp"
#include "core/engine/geometry/box_tree.hpp"
#include "core/engine/spacing/parts/automatic/boundary_spacing.hpp"
#include "core/engine/spacing/parts/automatic/chain_places.hpp"
#include "core/engine/spacing/parts/automatic/crowded_nodes.hpp"

#include <cstdint>
#include <limits>
#include <vector>

namespace forefront {

/// Segments, and points as segments of zero length, with the tree that finds those near a place.
struct SegmentIndex {
    explicit SegmentIndex(std::vector<PlacedSegment> placed);

    std::vector<PlacedSegment> segments;
    BoxTree tree; ///< items are indices into `segments`
};

/// A part of a domain segment and the width of the domain across from it.
struct Gap {
    Vec2 a;
    Vec2 b;
    double wholeLength = 0.0;  ///< length of the segment or curve that the part belongs to
    double width = 0.0;        ///< minimum distance across the domain to the opposite side
    std::uint32_t segment = 0; ///< index into Domain::segments
    bool corner = false;       ///< the facing segment is a neighbour at a sharp corner
};

/// Fraction of the domain's diagonal; narrower places are not resolved further.
inline constexpr double kFinestGap = 1e-4;

/// The criteria for a narrow gap.
struct GapRules {
    double across = 2.0; ///< elements of the maximum spacing that fit into the widest gap
    /// True: gaps are found beside short segments, too, and however narrow they are; corners are gaps only below 20
    /// degrees. False: a gap beside a segment counts only if elements as long as the segment are too large for it.
    bool everywhere = false;
};

/// Finds where the domain is narrow.
///
/// For each part of a boundary or constraint, looks for the part of the domain that faces it within GapRules::across
/// times the longest useful element, at most 60 degrees off the normal. Sides that open like a corner of 60 degrees or
/// more, however many segments there are between them, also where a third line ends, do not face each other. Divides
/// parts until the width along each varies by at most 5 % (beside curves 20 %), or they are no longer than that width
/// or `shortest`. Under the even-odd rule, decides inside and outside by counting in floating point, once per chain,
/// which is good enough for sizes; with hole markers by the faces of the domain, since the roles of segments then do
/// not tell. Leaves out long gaps, and tips of corners below 20 degrees, that are narrower than 1/32 of the longest
/// useful element: finer elements would add to their number, not to their quality. With GapRules::everywhere, it leaves
/// out only corners of 20 degrees or more, tips narrower than 1/8 of that element, and gaps narrower than `shortest`.
class GapFinder {
  public:
    /// `longest` is the maximum spacing; parts shorter than `shortest` are not divided. `index` holds the segments,
    /// then the lone points, numbered after the segments.
    GapFinder(const Domain &domain, const LazyFaces &faces, const SegmentIndex &index, double longest, double shortest,
              const Progress &progress, GapRules rules = {});

    /// Returns all gaps; after cancelling, those found so far.
    std::vector<Gap> find() const;
    /// Returns the distance from a lone point to the nearest segment or point, at most `longest`.
    double clearance(std::uint32_t position) const;

  private:
    struct Facing {
        double width = std::numeric_limits<double>::infinity(); ///< infinite: nothing faces the part
        std::uint32_t wall = kNoIndex;                          ///< position of the facing segment
        bool corner = false;                                    ///< the facing segment is a neighbour
        double opening = 0.0;                                   ///< then the width at the distance 1 from the corner
        bool needle = false; ///< the facing segment is a neighbour at a corner of less than 20 degrees
        bool tip = false;    ///< the part starts at a corner of less than 60 degrees
    };
    struct Sides {
        bool left = false;
        bool right = false;
    };
    bool isPoint(const PlacedSegment &segment) const;
    bool isWall(std::uint32_t position) const; ///< a boundary segment
    Sides insideOf(std::uint32_t position) const;
    struct Continuations;
    enum class Direction : std::uint8_t { Unknown, Along, Against }; ///< of a segment along its chain
    Continuations findContinuations() const;
    std::vector<std::uint32_t> chainFrom(std::uint32_t first, const Continuations &continuations,
                                         std::vector<Direction> &directions) const;
    std::vector<Sides> sidesByFaces(const DomainFaces &found) const;
    std::vector<Sides> sidesByCounting() const;
    std::vector<Sides> findSides() const;
    /// Returns the longest useful element at a segment.
    double reachOf(const PlacedSegment &segment) const;
    /// Returns true for two walls with closest points `p` and `q` that open like a corner: a chain connects them, or
    /// they are on chains that end at the same node.
    bool openLikeCorner(std::uint32_t position, std::uint32_t other, Vec2 p, Vec2 q) const;
    /// Finds the nearest segment or point opposite the part of the segment from a to b. `likely`: position of a
    /// probable answer, such as the one of the previous part, or kNoIndex; it only speeds up the search.
    Facing facing(std::uint32_t position, Vec2 a, Vec2 b, double reach, Sides sides, std::uint32_t likely) const;
    Facing facingWithin(std::uint32_t position, Vec2 a, Vec2 b, double reach, Sides sides, std::uint32_t likely) const;
    struct Found {
        std::vector<Gap> gaps;
        std::uint32_t wall = kNoIndex; ///< the segment or point opposite the last part, if any
    };
    void divide(std::uint32_t position, double from, double to, double reach, Sides sides, Found &found) const;

    const Domain &domain_;
    const LazyFaces &faces_;
    const SegmentIndex &index_;
    std::vector<ChainPlace> places_; ///< per segment of the index
    CrowdedNodes crowded_;
    double longest_;
    double shortest_;
    Box2 box_;
    double rounding_; ///< bound on the error of distances
    const Progress &progress_;
    GapRules rules_;
};

} // namespace forefront
