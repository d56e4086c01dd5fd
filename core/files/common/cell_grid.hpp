#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"
#include "core/files/source/source.hpp"

#include <cstddef>
#include <vector>

namespace forefront {

/// Maximum number of values in a grid that is used as spacing. The project file holds them as text.
inline constexpr std::size_t kMaxGridValues = 250'000;

/// Numbers of columns and rows of values.
struct GridCounts {
    std::size_t columns = 0, rows = 0;
};
/// Returns how many columns and rows of values a picture or grid gets: as many as it has itself, or both divided by the
/// same whole number so that there are at most `most` values.
GridCounts averagedCounts(std::size_t columns, std::size_t rows, std::size_t most);

/// A grid of rectangular cells with a size each.
struct CellGrid {
    std::size_t columns = 0, rows = 0;
    Vec2 low;                   ///< lower left corner
    Vec2 step;                  ///< width and height of a cell
    std::vector<double> values; ///< row by row from the top; 0: none
};

/// Returns the spacing of a background mesh with the sizes of a grid. A size holds at the centre of its cell; between
/// the centres the spacing is linear, and constant in the outer halves of the outer cells. Notes cells whose size is
/// not used because too few neighbours have one. Fault: no-values (no triangle has three values).
Result<SpacingSpec> spacingOfGrid(const CellGrid &grid, const SourceText &source);

} // namespace forefront
