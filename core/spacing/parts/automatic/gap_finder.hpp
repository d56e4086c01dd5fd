#pragma once

#include "core/base/progress.hpp"
#include "core/domain/domain.hpp"
#include "core/geometry/box_tree.hpp"
#include "core/spacing/parts/automatic/boundary_spacing.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Segments (and points as segments without length) with the tree that finds those near a place.
struct SegmentIndex {
    explicit SegmentIndex(std::vector<PlacedSegment> placed);

    std::vector<PlacedSegment> segments;
    BoxTree tree; ///< items are indices into `segments`
};

/// A stretch of a domain segment and the width of the domain across from it.
struct Gap {
    Vec2 a;
    Vec2 b;
    double width = 0.0;        ///< least distance across the domain to what faces the stretch
    std::uint32_t segment = 0; ///< index into Domain::segments
    bool corner = false;       ///< what faces it is a neighbour at a sharp corner
};

/// Finds where the domain is narrow: for each stretch of boundary or constraint, what faces it across the domain within
/// `reach`(its longest useful element) at less than twice that. Stretches are divided until the width varies by less
/// than 2x along each, or they are `shortest` long. The far side counts when it lies within 60 degrees of the normal.
/// Inside is told by even-odd counting, exact enough for sizes whatever the rule of the domain.
class GapFinder {
  public:
    /// `longest`: greatest spacing. `shortest`: no finer stretches. The index holds the segments, then the lone points
    /// (their `index` counts on from the segments).
    GapFinder(const Domain &domain, const SegmentIndex &index, double longest, double shortest,
              const Progress &progress);

    /// Cancelled runs return what was found so far.
    std::vector<Gap> find() const;
    /// Distance from a lone point to the nearest other thing, at most `longest`.
    double clearance(std::uint32_t position) const;

  private:
    struct Facing {
        double width = 0.0; ///< infinite: nothing
        bool corner = false;
        bool tip = false; ///< the stretch starts at a corner below 60 degrees
    };
    struct Sides {
        bool left = false;
        bool right = false;
    };
    bool isPoint(const PlacedSegment &segment) const;
    Sides insideOf(std::uint32_t position) const;
    /// What faces the stretch from a to b of the segment.
    Facing facing(std::uint32_t position, Vec2 a, Vec2 b, double reach, Sides sides) const;
    void divide(std::uint32_t position, double from, double to, double reach, Sides sides,
                std::vector<Gap> &gaps) const;

    const Domain &domain_;
    const SegmentIndex &index_;
    double longest_;
    double shortest_;
    Box2 box_;
    const Progress &progress_;
};

} // namespace forefront
