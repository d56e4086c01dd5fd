#pragma once

#include "core/drawing/shapes/shape_geometry.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace forefront {

/// Consecutive segments of an outline with the same tag.
struct TagRun {
    std::int32_t tag = 1;
    std::size_t first = 0; ///< index of the first segment
    std::size_t count = 0; ///< in a closed outline, a run may go on over the first node

    /// Returns the index of a segment of the run in an outline with `segments` segments.
    std::size_t segment(std::size_t k, std::size_t segments) const {
        return first + k < segments ? first + k : first + k - segments;
    }
};

/// Returns the runs of a shape in the order of its segments; one for a circle or an ellipse, none for a point.
/// `outline` is the outline of the shape.
std::vector<TagRun> tagRuns(const Shape &shape, const Outline &outline);

} // namespace forefront
