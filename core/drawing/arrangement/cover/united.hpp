#pragma once

#include "core/drawing/arrangement/arrangement.hpp"

#include <vector>

namespace forefront {

/// A closed loop; its first node is not repeated at the end.
struct OutlineRing {
    std::vector<Vec2> nodes;
    std::vector<CurveStretch> stretches; ///< per node: the part of a curve that the piece starting there follows
    std::vector<std::uint32_t> labels;   ///< per node: a number that the caller gives the piece starting there
};

/// An area between closed loops.
struct OutlinedArea {
    FillRule rule = FillRule::NonZero;
    std::vector<Curve> curves; ///< that pieces are chords of
    std::vector<OutlineRing> rings;

    std::size_t nodeCount() const;
};

/// Adds an area to a shape as a contour; the tags of its pieces are their labels + 1. Returns the index of the contour.
std::uint32_t addArea(ArrangementInput &input, std::uint32_t shape, const OutlinedArea &area);

/// Unites areas in groups of neighbours in the given order, then those unions, and so on. Pieces inside a union are
/// dropped before they can cross the rest. Returns one area; more if some cannot be united, or if a group is so thin
/// that its union would be empty: those areas are returned unchanged. Nodes move by at most `tolerance`, in domain
/// units, at each of about log(count) / log(8) steps. Labels survive; where outlines coincide, the first area gives
/// them.
std::vector<OutlinedArea> uniteAreas(std::vector<OutlinedArea> areas, double tolerance);

} // namespace forefront
