#include "core/engine/spacing/spec/size_grid.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/spacing/spec/grid_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace forefront {
namespace {

/// Divides the rectangles of a grid into triangles.
void addTriangles(std::size_t columns, std::size_t rows, const std::vector<std::uint32_t> &nodes,
                  BackgroundMesh &mesh) {
    for (std::size_t j = 0; j + 1 < rows; ++j) {
        for (std::size_t i = 0; i + 1 < columns; ++i) {
            const std::size_t at = j * columns + i, above = at + columns;
            const std::array<std::uint32_t, 4> corners{nodes[at], nodes[at + 1], nodes[above + 1], nodes[above]};
            std::array<std::uint32_t, 4> known{};
            const auto end = std::copy_if(corners.begin(), corners.end(), known.begin(),
                                          [](std::uint32_t node) { return node != GridMesh::kAbsent; });
            for (std::ptrdiff_t k = 2; k < end - known.begin(); ++k) {
                mesh.elements.push_back(
                    {known[0], known[static_cast<std::size_t>(k - 1)], known[static_cast<std::size_t>(k)]});
            }
        }
    }
}

Diagnostics badGrid(std::string message) {
    return error("bad-grid", "grid of sizes: " + std::move(message));
}

Diagnostics checkGrid(const SizeGrid &grid) {
    const auto positive = [](double number) { return number > 0.0 && std::isfinite(number); };
    if (!isFinite(grid.origin) || !positive(grid.pitch.x) || !positive(grid.pitch.y)) {
        return badGrid("origin " + placeText(grid.origin) + " and pitch " + placeText(grid.pitch) +
                       "; expected finite numbers and a positive pitch");
    }
    constexpr std::size_t kMaxValues = GridMesh::kAbsent;
    const bool tooMany = grid.columns != 0 && grid.rows >= kMaxValues / grid.columns;
    if (tooMany || grid.values.size() != grid.columns * grid.rows) {
        return badGrid(std::to_string(grid.values.size()) + " values for " + std::to_string(grid.columns) +
                       " columns and " + std::to_string(grid.rows) + " rows" +
                       (tooMany ? ", which are too many" : "; expected one for each"));
    }
    for (std::size_t k = 0; k < grid.values.size(); ++k) {
        if (!std::isnan(grid.values[k]) && !positive(grid.values[k])) {
            Diagnostics faults = badGrid("value " + numberText(grid.values[k], 6) +
                                         "; expected a positive number, or NaN where there is none");
            faults.front().at = grid.place(k % grid.columns, k / grid.columns);
            faults.front().ids = {static_cast<std::uint32_t>(k)};
            return faults;
        }
    }
    return {};
}

} // namespace

GridMesh gridMesh(std::span<const double> x, std::span<const double> y, std::span<const double> values) {
    auto mesh = std::make_shared<BackgroundMesh>();
    std::vector<std::uint32_t> nodes(values.size(), GridMesh::kAbsent);
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (values[k] > 0.0) {
            nodes[k] = static_cast<std::uint32_t>(mesh->nodes.size());
            mesh->nodes.push_back({x[k % x.size()], y[k / x.size()]});
            mesh->values.push_back(values[k]);
        }
    }
    addTriangles(x.size(), y.size(), nodes, *mesh);
    return {std::move(mesh), std::move(nodes)};
}

Result<std::shared_ptr<const BackgroundMesh>> backgroundOf(const SizeGrid &grid) {
    if (Diagnostics faults = checkGrid(grid); !faults.empty()) {
        return faults;
    }
    std::vector<double> x(grid.columns), y(grid.rows);
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] = grid.place(i, 0).x;
    }
    for (std::size_t j = 0; j < y.size(); ++j) {
        y[j] = grid.place(0, j).y;
    }
    std::shared_ptr<const BackgroundMesh> mesh = gridMesh(x, y, grid.values).mesh;
    if (mesh->elements.empty()) {
        return error("no-values", "grid of sizes: no three neighbouring values; expected at least three");
    }
    return mesh;
}

} // namespace forefront
