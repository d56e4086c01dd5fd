#include "core/grid/uniform_grid.hpp"

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

void UniformGrid::insert(const GenerationFront &front, SlotId id) {
    const Box2 box = boxOf(front.start(id), front.end(id));
    forEachCrossedCell(layout_, front.start(id), front.end(id), slack_,
                       [&](int i, int j) { blocks_.push(lists_[cell(i, j)], id, CellScale(layout_, i, j)(box)); });
}

void UniformGrid::remove(const GenerationFront &front, SlotId id) {
    forEachCrossedCell(layout_, front.start(id), front.end(id), slack_,
                       [&](int i, int j) { blocks_.erase(lists_[cell(i, j)], id); });
}

} // namespace forefront
