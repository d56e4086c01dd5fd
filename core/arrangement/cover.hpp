#pragma once

#include "core/arrangement/arrangement.hpp"
#include "core/arrangement/snap.hpp"
#include "core/domain/faces.hpp"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace forefront {

/// How often a contour runs along an edge, forth less back.
struct ContourRun {
    std::uint32_t contour = 0;
    std::int32_t times = 0;
};

/// The outlines along each edge: runs[starts[e]] to runs[starts[e + 1]], by contour. Times may be 0: forth and back.
struct EdgeRuns {
    std::vector<std::uint32_t> starts;
    std::vector<ContourRun> runs;
};

/// What covers the faces.
struct FaceCover {
    std::vector<std::uint32_t> shapes;      ///< per face: how many shapes cover it
    std::vector<std::uint32_t> owner;       ///< per face: the feature it belongs to, or kNoIndex outside
    std::vector<std::uint32_t> rivalStarts; ///< features that cover a face, if several: a range of rivals per face
    std::vector<std::uint32_t> rivals;      ///< by index
    std::vector<double> area;               ///< per face; of the unbounded one without meaning
    /// Pairs of features where the first lies inside the second.
    std::map<std::pair<std::uint32_t, std::uint32_t>, bool> nested;
    /// Per edge: how many shapes cover its left face but not its right one.
    std::vector<std::uint32_t> ends;
};

/// Winding numbers of all contours on all faces, and what follows from them. Each contour must consist of closed loops.
FaceCover coverFaces(const ArrangementInput &input, const std::vector<Vec2> &nodes, const std::vector<PlaneEdge> &edges,
                     const EdgeRuns &runs, const Faces &faces);

} // namespace forefront
