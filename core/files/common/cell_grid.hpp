#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"
#include "core/files/source/source.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
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

/// Averages the values of a grid over the rectangles of a coarser one, as pictures are averaged.
class CellMeans {
  public:
    CellMeans(std::size_t columns, std::size_t rows, CellGrid &coarse)
        : columns_(columns), rows_(rows), coarse_(coarse), cells_(coarse.columns * coarse.rows) {}

    /// Adds value k of the fine grid, row by row from the top.
    void add(std::size_t k, std::optional<double> value) {
        const std::size_t row = k / columns_ * coarse_.rows / rows_;
        Cell &cell = cells_[row * coarse_.columns + k % columns_ * coarse_.columns / columns_];
        cell.sum += value.value_or(0.0);
        ++(value ? cell.known : cell.missing);
    }
    /// Fills in the values of the coarse grid: none where most are missing.
    void finish();

  private:
    struct Cell {
        double sum = 0.0;
        std::uint32_t known = 0, missing = 0;
    };
    std::size_t columns_, rows_;
    CellGrid &coarse_;
    std::vector<Cell> cells_;
};

/// Notes that a grid of columns x rows values was averaged, if it was.
void noteAveraged(const CellGrid &grid, std::size_t columns, std::size_t rows, const SourceText &source);

/// Returns the spacing of a background mesh with the sizes of a grid. A size holds at the centre of its cell; between
/// the centres the spacing is linear, and constant in the outer halves of the outer cells. Notes cells whose size is
/// not used because too few neighbours have one. Fault: no-values (no triangle has three values).
Result<SpacingSpec> spacingOfGrid(const CellGrid &grid, const SourceText &source);

} // namespace forefront
