#include "core/files/common/size_grid.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <utility>

namespace forefront {
namespace {

/// Makes the background mesh of a grid.
class GridMesh {
  public:
    explicit GridMesh(const SizeGrid &grid) : grid_(grid) {
        addNodes();
        addTriangles();
    }

    std::shared_ptr<const BackgroundMesh> mesh() const { return mesh_; }

    /// Returns the number of cells with a size that no triangle uses, such as those of a strip one cell wide between
    /// cells without one.
    std::size_t isolated() const {
        std::vector<std::uint8_t> used(mesh_->nodes.size(), 0);
        for (const auto &element : mesh_->elements) {
            for (const std::uint32_t node : element) {
                used[node] = 1;
            }
        }
        std::size_t count = 0;
        for (std::size_t j = 1; j <= grid_.rows; ++j) {
            for (std::size_t i = 1; i <= grid_.columns; ++i) {
                const std::uint32_t node = nodes_[j * (grid_.columns + 2) + i];
                count += node != kAbsent && used[node] == 0 ? 1 : 0;
            }
        }
        return count;
    }

  private:
    static constexpr std::uint32_t kAbsent = std::numeric_limits<std::uint32_t>::max();

    /// Returns the index of the cell whose value holds at node line i of n + 2: those at the ends repeat the outer
    /// cells.
    static std::size_t cellOf(std::size_t i, std::size_t n) { return std::clamp<std::size_t>(i, 1, n) - 1; }
    static double placeOf(std::size_t i, std::size_t n, double low, double step) {
        const double cells = i == 0 ? 0.0 : i == n + 1 ? static_cast<double>(n) : static_cast<double>(i) - 0.5;
        return low + cells * step;
    }

    /// Adds a node for each centre of a cell, and for each edge of the grid beside one, that has a value.
    void addNodes() {
        const std::size_t columns = grid_.columns, rows = grid_.rows;
        nodes_.assign((columns + 2) * (rows + 2), kAbsent);
        for (std::size_t j = 0; j < rows + 2; ++j) {
            for (std::size_t i = 0; i < columns + 2; ++i) {
                const std::size_t row = rows - 1 - cellOf(j, rows); // the first row is the highest
                const double value = grid_.values[row * columns + cellOf(i, columns)];
                if (value > 0.0) {
                    nodes_[j * (columns + 2) + i] = static_cast<std::uint32_t>(mesh_->nodes.size());
                    mesh_->nodes.push_back(
                        {placeOf(i, columns, grid_.low.x, grid_.step.x), placeOf(j, rows, grid_.low.y, grid_.step.y)});
                    mesh_->values.push_back(value);
                }
            }
        }
    }

    /// Divides each rectangle of four nodes into two triangles; one with three nodes is a single triangle.
    void addTriangles() {
        for (std::size_t j = 0; j + 1 < grid_.rows + 2; ++j) {
            for (std::size_t i = 0; i + 1 < grid_.columns + 2; ++i) {
                const std::size_t at = j * (grid_.columns + 2) + i, above = at + grid_.columns + 2;
                const std::array<std::uint32_t, 4> corners{nodes_[at], nodes_[at + 1], nodes_[above + 1],
                                                           nodes_[above]};
                std::array<std::uint32_t, 4> known{};
                const auto end = std::copy_if(corners.begin(), corners.end(), known.begin(),
                                              [](std::uint32_t node) { return node != kAbsent; });
                for (std::ptrdiff_t k = 2; k < end - known.begin(); ++k) {
                    mesh_->elements.push_back(
                        {known[0], known[static_cast<std::size_t>(k - 1)], known[static_cast<std::size_t>(k)]});
                }
            }
        }
    }

    const SizeGrid &grid_;
    std::vector<std::uint32_t> nodes_; ///< index of each node, row by row from the bottom; kAbsent: none
    std::shared_ptr<BackgroundMesh> mesh_ = std::make_shared<BackgroundMesh>();
};

} // namespace

GridCounts averagedCounts(std::size_t columns, std::size_t rows, std::size_t most) {
    const auto divided = [](std::size_t count, std::size_t by) { return (count + by - 1) / by; };
    std::size_t by = 1;
    while (divided(columns, by) * divided(rows, by) > most) {
        ++by;
    }
    return {divided(columns, by), divided(rows, by)};
}

Result<SpacingSpec> spacingOfGrid(const SizeGrid &grid, const SourceText &source) {
    const GridMesh made(grid);
    SpacingSpec spec;
    spec.background = made.mesh();
    if (spec.background->elements.empty()) {
        return Diagnostics{
            faultAt(source, 0, "no-values", "no three neighbouring cells have a size; expected at least three")};
    }
    if (const std::size_t isolated = made.isolated(); isolated > 0) {
        source.note("isolated-sizes",
                    std::to_string(isolated) + (isolated == 1 ? " cell has a size" : " cells have sizes") +
                        " not used: expected at least two neighbours with sizes, not all in one line",
                    0);
    }
    return spec;
}

} // namespace forefront
