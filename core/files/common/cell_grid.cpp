#include "core/files/common/cell_grid.hpp"

#include "core/engine/spacing/spec/grid_mesh.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace forefront {
namespace {

/// Returns the index of the cell whose value holds at line i of n + 2: those at the ends repeat the outer cells.
std::size_t cellOf(std::size_t i, std::size_t n) {
    return std::clamp<std::size_t>(i, 1, n) - 1;
}

/// Returns the places of the centres of n cells, and of the outer edges of the first and the last one.
std::vector<double> linesOf(std::size_t n, double low, double step) {
    std::vector<double> lines(n + 2);
    for (std::size_t i = 0; i < n + 2; ++i) {
        const double cells = i == 0 ? 0.0 : i == n + 1 ? static_cast<double>(n) : static_cast<double>(i) - 0.5;
        lines[i] = low + cells * step;
    }
    return lines;
}

/// Returns the background mesh of a grid, with a node at the centre of each cell that has a size, and at each edge of
/// the grid beside one.
GridMesh meshOf(const CellGrid &grid) {
    std::vector<double> values;
    values.reserve((grid.columns + 2) * (grid.rows + 2));
    for (std::size_t j = 0; j < grid.rows + 2; ++j) {
        const std::size_t row = grid.rows - 1 - cellOf(j, grid.rows); // the first row is the highest
        for (std::size_t i = 0; i < grid.columns + 2; ++i) {
            values.push_back(grid.values[row * grid.columns + cellOf(i, grid.columns)]);
        }
    }
    return gridMesh(linesOf(grid.columns, grid.low.x, grid.step.x), linesOf(grid.rows, grid.low.y, grid.step.y),
                    values);
}

/// Returns the number of cells with a size that no triangle uses, such as those of a strip one cell wide between cells
/// without one.
std::size_t isolatedCells(const CellGrid &grid, const GridMesh &made) {
    std::vector<std::uint8_t> used(made.mesh->nodes.size(), 0);
    for (const auto &element : made.mesh->elements) {
        for (const std::uint32_t node : element) {
            used[node] = 1;
        }
    }
    std::size_t count = 0;
    for (std::size_t j = 1; j <= grid.rows; ++j) {
        for (std::size_t i = 1; i <= grid.columns; ++i) {
            const std::uint32_t node = made.nodes[j * (grid.columns + 2) + i];
            count += node != GridMesh::kAbsent && used[node] == 0 ? 1 : 0;
        }
    }
    return count;
}

} // namespace

Result<SpacingSpec> spacingOfGrid(const CellGrid &grid, const SourceText &source) {
    const GridMesh made = meshOf(grid);
    SpacingSpec spec;
    spec.background = made.mesh;
    if (spec.background->elements.empty()) {
        return Diagnostics{
            faultAt(source, 0, "no-values", "no three neighbouring cells have a size; expected at least three")};
    }
    if (const std::size_t isolated = isolatedCells(grid, made); isolated > 0) {
        source.note("isolated-sizes",
                    std::to_string(isolated) + (isolated == 1 ? " cell has a size" : " cells have sizes") +
                        " not used: expected at least two neighbours with sizes, not all in one line",
                    0);
    }
    return spec;
}

void CellMeans::finish() {
    coarse_.values.reserve(cells_.size());
    for (const Cell &cell : cells_) {
        const bool none = cell.known == 0 || cell.known < cell.missing;
        coarse_.values.push_back(none ? 0.0 : cell.sum / static_cast<double>(cell.known));
    }
}

void noteAveraged(const CellGrid &grid, std::size_t columns, std::size_t rows, const SourceText &source) {
    if (grid.columns < columns || grid.rows < rows) {
        source.note("grid-averaged",
                    "the grid has " + std::to_string(columns) + " x " + std::to_string(rows) + " values; averaged to " +
                        std::to_string(grid.columns) + " x " + std::to_string(grid.rows),
                    0);
    }
}

GridCounts averagedCounts(std::size_t columns, std::size_t rows, std::size_t most) {
    const auto divided = [](std::size_t count, std::size_t by) { return (count + by - 1) / by; };
    std::size_t by = 1;
    while (divided(columns, by) * divided(rows, by) > most) {
        ++by;
    }
    return {divided(columns, by), divided(rows, by)};
}

} // namespace forefront
