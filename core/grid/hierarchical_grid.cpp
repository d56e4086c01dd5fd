#include "core/grid/hierarchical_grid.hpp"

namespace forefront {

namespace {

// A leaf splits for a segment shorter than half of 1/kCellPerLength of its width, into cells of about that length times
// kCellPerLength. Measured on uniform and graded cases: flat between 4 and 8.
constexpr double kCellPerLength = 4.5;
constexpr int kTopCells = 8;
constexpr int kMostCells = 16;

} // namespace

HierarchicalGrid::HierarchicalGrid(const Box2 &bounds, double slack) : slack_(slack) {
    const Vec2 size = bounds.size();
    const double cellSize = std::max(std::max(size.x, size.y) / kTopCells, 64.0 * slack_);
    const auto cellsAlong = [&](double extent) {
        return std::clamp(static_cast<int>(std::ceil(extent / cellSize)), 1, kTopCells);
    };
    const int columns = cellsAlong(size.x);
    const int rows = cellsAlong(size.y);
    addTable({bounds.min, {bounds.min.x + columns * cellSize, bounds.min.y + rows * cellSize}}, columns, rows);
}

std::uint32_t HierarchicalGrid::addTable(const Box2 &box, int columns, int rows) {
    const Vec2 size = box.size();
    Table table;
    table.lattice = {box.min, {size.x / columns, size.y / rows}, columns, rows};
    table.box = box;
    table.firstCell = cells_.size();
    cells_.resize(cells_.size() + static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    tables_.push_back(table);
    return static_cast<std::uint32_t>(tables_.size() - 1);
}

std::uint32_t HierarchicalGrid::tableAround(const Box2 &box) const {
    // With a margin: a table's box and the cell above it may differ by rounding.
    const Box2 last = tables_[last_].box.grown(-slack_);
    if (!(last.min.x <= box.min.x && box.max.x < last.max.x && last.min.y <= box.min.y && box.max.y < last.max.y)) {
        last_ = 0;
    }
    for (;;) {
        const Table &table = tables_[last_];
        const int i = table.lattice.column(box.min.x);
        const int j = table.lattice.row(box.min.y);
        if (table.lattice.column(box.max.x) != i || table.lattice.row(box.max.y) != j) {
            return last_;
        }
        const std::uint32_t below = cells_[cell(table, i, j)].table;
        if (below == kLeaf) {
            return last_;
        }
        last_ = below;
    }
}

bool HierarchicalGrid::tooCoarse(const Lattice &lattice, double length) const {
    return lattice.cellWidth > 2.0 * kCellPerLength * length && lattice.cellWidth > 1024.0 * slack_;
}

void HierarchicalGrid::insert(const GenerationFront &front, SlotId id) {
    if (places_.size() <= index(id)) {
        places_.resize(std::max(front.capacity(), index(id) + 1));
    }
    pushed_ = 0;
    insertInto(tableAround(boxOf(front.start(id), front.end(id)).grown(slack_)), front, id);
    if (pushed_ != 1) {
        places_[index(id)].table = Place::kNowhere;
    }
}

void HierarchicalGrid::remove(const GenerationFront &front, SlotId id) {
    const Place &place = places_[index(id)];
    if (place.table != Place::kNowhere) {
        CellContent &content = cells_[cell(tables_[place.table], place.i, place.j)];
        if (content.table == kLeaf) {
            lists_.erase(content.head, id);
            return;
        }
    }
    removeFrom(tableAround(boxOf(front.start(id), front.end(id)).grown(slack_)), front, id);
}

bool HierarchicalGrid::keeps(SlotId id, Vec2 a, Vec2 b) const {
    const Place &place = places_[index(id)];
    if (place.table == Place::kNowhere) {
        return false;
    }
    const Table &table = tables_[place.table];
    const Box2 box = table.lattice.cellBox(place.i, place.j).grown(-slack_);
    const double least = table.lattice.cellWidth / (2.0 * kCellPerLength);
    return box.contains(a) && box.contains(b) && distanceSquared(a, b) >= least * least &&
           cells_[cell(table, place.i, place.j)].table == kLeaf;
}

void HierarchicalGrid::insertInto(std::uint32_t tableIndex, const GenerationFront &front, SlotId id) {
    const Lattice lattice = tables_[tableIndex].lattice; // a copy: splitting may move the tables
    const double length = front[id].length;
    const bool splits = tooCoarse(lattice, length) && !front.isolated(id);
    forEachCrossedCell(lattice, front.start(id), front.end(id), slack_, [&](int i, int j) {
        const std::size_t at = cell(tables_[tableIndex], i, j);
        if (cells_[at].table == kLeaf && splits) {
            split(at, lattice.cellBox(i, j), length, front);
        }
        if (cells_[at].table == kLeaf) {
            lists_.push(cells_[at].head, id);
            places_[index(id)] = {tableIndex, i, j};
            ++pushed_;
        } else {
            insertInto(cells_[at].table, front, id);
        }
    });
}

void HierarchicalGrid::split(std::size_t cellIndex, const Box2 &box, double length, const GenerationFront &front) {
    const double width = box.max.x - box.min.x;
    const int n = static_cast<int>(
        std::clamp(std::ceil(width / (kCellPerLength * length)), 2.0, static_cast<double>(kMostCells)));
    std::vector<SlotId> residents;
    lists_.forEach(cells_[cellIndex].head, [&](SlotId id) { residents.push_back(id); });
    for (const SlotId id : residents) {
        lists_.erase(cells_[cellIndex].head, id);
    }
    const std::uint32_t table = addTable(box, n, n);
    cells_[cellIndex].table = table;
    const Lattice lattice = tables_[table].lattice;
    for (const SlotId id : residents) {
        forEachCrossedCell(lattice, front.start(id), front.end(id), slack_,
                           [&](int i, int j) { lists_.push(cells_[cell(tables_[table], i, j)].head, id); });
    }
}

void HierarchicalGrid::removeFrom(std::uint32_t tableIndex, const GenerationFront &front, SlotId id) {
    const Table &table = tables_[tableIndex];
    forEachCrossedCell(table.lattice, front.start(id), front.end(id), slack_, [&](int i, int j) {
        CellContent &content = cells_[cell(table, i, j)];
        if (content.table == kLeaf) {
            lists_.erase(content.head, id);
        } else {
            removeFrom(content.table, front, id);
        }
    });
}

} // namespace forefront
