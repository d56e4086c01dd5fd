#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/vec2.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace FOREFRONT_API forefront {

/// How a mesh of quadrilaterals was made.
struct QuadReport {
    std::uint64_t rows = 0;     ///< squares of the front that continued a row
    std::uint64_t openings = 0; ///< squares that started one
    std::uint64_t closings = 0; ///< squares that closed a gap
    std::uint64_t searched = 0; ///< halves of squares that the front searched for
    bool lattice = false;       ///< a lattice grew inside the rows along the boundary; else rows to the end
    std::size_t addedNodes = 0; ///< on the boundary, so that cycles of edges are even
    std::size_t oddEdges = 0;   ///< edges that close an odd cycle but had to stay
    std::size_t changes = 0;    ///< of the clean-up
    std::size_t triangles = 0;  ///< left in the mesh
    std::size_t quadrilaterals = 0;
    std::size_t notConvex = 0;     ///< quadrilaterals with a corner of 180 degrees or more
    std::vector<Vec2> notConvexAt; ///< that corner of each
    /// Where triangles are left since no quadrilaterals would be convex; one place for each such pocket of the domain.
    std::vector<Vec2> trianglesAt;
    std::size_t irregularNodes = 0; ///< inside, with other than four elements
    std::size_t innerNodes = 0;

    /// Returns the share of the interior nodes that are irregular.
    double irregularShare() const {
        return innerNodes == 0 ? 0.0 : static_cast<double>(irregularNodes) / static_cast<double>(innerNodes);
    }

    friend bool operator==(const QuadReport &, const QuadReport &) = default;
};

} // namespace forefront
