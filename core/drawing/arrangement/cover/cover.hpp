#pragma once

#include "core/drawing/arrangement/arrangement.hpp"
#include "core/drawing/arrangement/snapping/snap_lines.hpp"
#include "core/engine/domain/faces.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// The number of times a contour runs along an edge: forward minus backward.
struct ContourRun {
    std::uint32_t contour = 0;
    std::int32_t times = 0;
};

/// The outlines along each edge e: runs[starts[e]] up to but excluding runs[starts[e + 1]], sorted by contour. A
/// contour that runs forward and back counts 0 times.
struct EdgeRuns {
    std::vector<std::uint32_t> starts;
    std::vector<ContourRun> runs;
};

/// A line along an edge that only counts where its clip shows it.
struct ClippedLine {
    std::uint32_t edge = 0;
    std::uint32_t clip = 0;
    bool shown = false; ///< set by coverFaces: the clip shows a face beside the edge
};

/// The shapes and features that cover each face.
struct FaceCover {
    std::vector<std::uint32_t> shapes;      ///< per face: how many shapes cover it
    std::vector<std::uint32_t> owner;       ///< per face: the feature it belongs to, or kNoIndex outside
    std::vector<std::uint32_t> rivalStarts; ///< features that cover a face, if several: a range of rivals per face
    std::vector<std::uint32_t> rivals;      ///< sorted by index
    std::vector<double> area;               ///< per face; meaningless for the unbounded face
    std::vector<std::vector<std::uint32_t>>
        holders; ///< per feature: the features that cover all its faces, sorted by index
    /// Per edge: how many shapes cover its left face but not its right one.
    std::vector<std::uint32_t> ends;
    /// Per shape: an outline of a clip bounds the domain where it ends this shape. Empty without clips.
    std::vector<std::uint8_t> clipBounds;

    /// Returns true if the second feature covers all faces of the first, and more.
    bool nested(std::uint32_t inner, std::uint32_t outer) const;
};

/// Computes the winding numbers of all contours on all faces, and the shapes and features that cover each face. Each
/// contour must consist of closed loops. `lines` are sorted by edge; their `shown` is set.
FaceCover coverFaces(const ArrangementInput &input, const std::vector<Vec2> &nodes, const std::vector<PlaneEdge> &edges,
                     const EdgeRuns &runs, const Faces &faces, std::vector<ClippedLine> &lines);

} // namespace forefront
