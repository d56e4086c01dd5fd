#include "core/engine/grid/uniform_grid.hpp"

#include "core/engine/boundary/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace forefront {

namespace {

CellLayout layoutOver(const Box2 &bounds, int columns, int rows) {
    const Vec2 size = bounds.size();
    const double minSize = gridSlack(bounds) * 8.0;
    const int c = std::max(columns, 1), r = std::max(rows, 1);
    return {bounds.min, {std::max(size.x / c, minSize), std::max(size.y / r, minSize)}, c, r};
}

} // namespace

UniformGrid::UniformGrid(const Box2 &bounds, int columns, int rows)
    : layout_(layoutOver(bounds, columns, rows)), slack_(gridSlack(bounds)),
      lists_(static_cast<std::size_t>(layout_.columns) * static_cast<std::size_t>(layout_.rows)) {}

UniformGrid UniformGrid::create(const GridRequest &request) {
    constexpr double kMostCells = 4e6;
    const Box2 bounds = request.domain.bounds();
    const Vec2 size = bounds.size();
    const double elementArea = request.domain.area() / estimateElements(request.domain, request.spacing);
    const double meanSpacing = std::sqrt(elementArea * 4.0 / std::numbers::sqrt3);
    const double cell = std::max(3.0 * meanSpacing, std::sqrt(size.x * size.y / kMostCells));
    const auto cellsAlong = [&](double extent, int given) {
        return given > 0 ? given : static_cast<int>(std::clamp(std::ceil(extent / cell), 1.0, kMostCells));
    };
    return {bounds, cellsAlong(size.x, request.columns), cellsAlong(size.y, request.rows)};
}

void UniformGrid::insert(const GenerationFront &front, SlotId id) {
    const Box2 ends = boxOf(front.start(id), front.end(id));
    const Box2 box = ends.grown(gridSlack(ends));
    forEachCrossedCell(layout_, front.start(id), front.end(id), slack_, slack_,
                       [&](int i, int j) { blocks_.push(lists_[cell(i, j)], id, CellScale(layout_, i, j)(box)); });
}

void UniformGrid::remove(const GenerationFront &front, SlotId id) {
    forEachCrossedCell(layout_, front.start(id), front.end(id), slack_, slack_,
                       [&](int i, int j) { blocks_.erase(lists_[cell(i, j)], id); });
}

} // namespace forefront
