#include "core/engine/grid/hierarchical_grid.hpp"

#include <limits>

namespace forefront {

namespace {

constexpr int kTopCells = 8;
constexpr int kMaxCells = 16; // limited by the bits of Place

} // namespace

HierarchicalGrid::HierarchicalGrid(const Box2 &bounds, double cellPerLength) : cellPerLength_(cellPerLength) {
    const Vec2 size = bounds.size();
    const double cellSize = std::max(std::max(size.x, size.y) / kTopCells, 64.0 * gridSlack(bounds));
    const auto cellsAlong = [&](double extent) {
        return std::clamp(static_cast<int>(std::ceil(extent / cellSize)), 1, kTopCells);
    };
    const int columns = cellsAlong(size.x);
    const int rows = cellsAlong(size.y);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    addTable({bounds.min, {bounds.min.x + columns * cellSize, bounds.min.y + rows * cellSize}}, columns, rows,
             {{-kInfinity, -kInfinity}, {kInfinity, kInfinity}}, 0);
}

HierarchicalGrid HierarchicalGrid::create(const GridRequest &request) {
    return {request.domain.bounds(), request.cellPerLength};
}

std::uint32_t HierarchicalGrid::addTable(const Box2 &box, int columns, int rows, const Box2 &inner,
                                         std::uint32_t above) {
    const Vec2 size = box.size();
    Table table;
    table.layout = {box.min, {size.x / columns, size.y / rows}, columns, rows};
    table.inner = inner;
    table.slack = gridSlack(box);
    table.above = above;
    table.firstCell = static_cast<std::uint32_t>(cells_.size());
    cells_.resize(cells_.size() + static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    tables_.push_back(table);
    return static_cast<std::uint32_t>(tables_.size() - 1);
}

std::uint32_t HierarchicalGrid::tableAround(const Box2 &box) const {
    while (last_ != 0 && !tables_[last_].inner.containsHalfOpen(box)) {
        last_ = tables_[last_].above;
    }
    for (;;) {
        const Table &table = tables_[last_];
        const int i = table.layout.column(box.min.x);
        const int j = table.layout.row(box.min.y);
        if (table.layout.column(box.max.x) != i || table.layout.row(box.max.y) != j) {
            return last_;
        }
        const std::uint32_t below = cells_[cell(table, i, j)].table;
        if (below == kLeaf) {
            return last_;
        }
        last_ = below;
    }
}

bool HierarchicalGrid::tooCoarse(const Table &table, double length) const {
    return table.layout.cellWidth > 2.0 * cellPerLength_ * length && table.layout.cellWidth > 1024.0 * table.slack;
}

void HierarchicalGrid::insert(const GenerationFront &front, SlotId id) {
    if (places_.size() <= index(id)) {
        places_.resize(std::max(front.capacity(), index(id) + 1));
    }
    pushed_ = 0;
    insertInto(tableAround(grownBox(front, id)), front, id);
    if (pushed_ != 1) {
        places_[index(id)].table = Place::kNowhere;
    }
}

void HierarchicalGrid::remove(const GenerationFront &front, SlotId id) {
    const Place &place = places_[index(id)];
    if (place.table != Place::kNowhere) {
        CellContent &content = cells_[place.cell];
        if (content.table == kLeaf) {
            blocks_.erase(content.list, id);
            return;
        }
    }
    removeFrom(tableAround(grownBox(front, id)), front, id);
}

bool HierarchicalGrid::keeps(SlotId id, Vec2 a, Vec2 b) const {
    const Place &place = places_[index(id)];
    if (place.table == Place::kNowhere) {
        return false;
    }
    const Table &table = tables_[place.table];
    const Box2 box = table.layout.cellBox(place.i, place.j).grown(-table.slack);
    const Box2 grown = boxOf(a, b).grown(table.slack);
    const double minLength = table.layout.cellWidth / (2.0 * cellPerLength_);
    return box.contains(a) && box.contains(b) && table.inner.containsHalfOpen(grown) &&
           distanceSquared(a, b) >= minLength * minLength && cells_[place.cell].table == kLeaf;
}

void HierarchicalGrid::moved(const GenerationFront &front, SlotId id) {
    const Place &place = places_[index(id)];
    blocks_.move(cells_[place.cell].list, id,
                 CellScale(tables_[place.table].layout, place.i, place.j)(grownBox(front, id)));
}

void HierarchicalGrid::insertInto(std::uint32_t tableIndex, const GenerationFront &front, SlotId id) {
    const Table table = tables_[tableIndex]; // a copy: splitting may move the tables
    const double length = front[id].length;
    const bool splits = tooCoarse(table, length) && !front.isolated(id);
    forEachCellOf(table, front, id, [&](int i, int j) {
        const std::uint32_t at = cell(table, i, j);
        if (cells_[at].table == kLeaf && splits) {
            split(tableIndex, at, table.layout.cellBox(i, j), length, front);
        }
        if (cells_[at].table == kLeaf) {
            blocks_.push(cells_[at].list, id, CellScale(table.layout, i, j)(grownBox(front, id)));
            places_[index(id)] = {tableIndex, at, static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j)};
            ++pushed_;
        } else {
            insertInto(cells_[at].table, front, id);
        }
    });
}

void HierarchicalGrid::split(std::uint32_t above, std::uint32_t cellIndex, const Box2 &box, double length,
                             const GenerationFront &front) {
    const double width = box.max.x - box.min.x;
    const int n = static_cast<int>(
        std::clamp(std::floor(width / (cellPerLength_ * length)), 2.0, static_cast<double>(kMaxCells)));
    std::vector<SlotId> residents;
    blocks_.forEach(cells_[cellIndex].list, [&](SlotId id) { residents.push_back(id); });
    for (const SlotId id : residents) {
        blocks_.erase(cells_[cellIndex].list, id);
    }
    // The layout above may map what lies a little outside the box to this cell, by its rounding. The new table extends
    // that far, so that parts which are far smaller than that still have different cells.
    const double margin = tables_[above].slack;
    Box2 inner = box.grown(-margin);
    inner.min = {std::max(inner.min.x, tables_[above].inner.min.x), std::max(inner.min.y, tables_[above].inner.min.y)};
    inner.max = {std::min(inner.max.x, tables_[above].inner.max.x), std::min(inner.max.y, tables_[above].inner.max.y)};
    const std::uint32_t below = addTable(box.grown(margin), n, n, inner, above);
    cells_[cellIndex].table = below;
    const Table &table = tables_[below];
    for (const SlotId id : residents) {
        const Box2 ends = grownBox(front, id);
        forEachCellOf(table, front, id, [&](int i, int j) {
            blocks_.push(cells_[cell(table, i, j)].list, id, CellScale(table.layout, i, j)(ends));
        });
    }
}

void HierarchicalGrid::removeFrom(std::uint32_t tableIndex, const GenerationFront &front, SlotId id) {
    const Table &table = tables_[tableIndex];
    forEachCellOf(table, front, id, [&](int i, int j) {
        CellContent &content = cells_[cell(table, i, j)];
        if (content.table == kLeaf) {
            blocks_.erase(content.list, id);
        } else {
            removeFrom(content.table, front, id);
        }
    });
}

} // namespace forefront
