#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace FOREFRONT_API forefront {

/// Element sizes on a regular grid, such as those sampled from a function or a depth chart.
struct SizeGrid {
    Vec2 origin;                       ///< place of the first value, at the lower left
    Vec2 pitch{1.0, 1.0};              ///< distance between columns and between rows, > 0
    std::size_t columns = 0, rows = 0; ///< number of values in each direction
    std::vector<double> values;        ///< row by row from the bottom, each from the left; > 0, or NaN: none

    /// Returns the place of a value.
    Vec2 place(std::size_t column, std::size_t row) const {
        return origin + Vec2{pitch.x * static_cast<double>(column), pitch.y * static_cast<double>(row)};
    }
};

/// Returns a grid of sizes as a background mesh, for SpacingSpec::background: each rectangle of four values is two
/// triangles, on which the size is linear, and one of three values is a single triangle. Elsewhere the background has
/// no size, and automatic spacing fills in; a value without two neighbours in a rectangle has no effect. Errors:
/// "bad-grid", with the place of the value if one is at fault; "no-values" if no rectangle has three values.
Result<std::shared_ptr<const BackgroundMesh>> backgroundOf(const SizeGrid &grid);

} // namespace forefront
