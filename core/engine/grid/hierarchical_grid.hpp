#pragma once

#include "core/engine/front/generation_front.hpp"
#include "core/engine/grid/cell_layout.hpp"
#include "core/engine/grid/cell_lists.hpp"
#include "core/engine/grid/grid_kind.hpp"
#include "core/engine/grid/grid_request.hpp"

#include <vector>

namespace forefront {

/// A background grid whose cells adapt to the lengths of the front segments. It starts with coarse cells; a cell splits
/// permanently into n x n when a segment much shorter than the cell enters it. So the number of delivered segments does
/// not grow with the ratio of sizes.
///
/// Nothing is missed: every layout maps a coordinate to a column that never falls as the coordinate grows. Where a
/// segment and a box come within half the larger of their slacks, the one with the larger slack, grown by it, contains
/// a point of the other, and all layouts map this point to a cell that both reach.
class HierarchicalGrid {
  public:
    static constexpr GridKind kKind = GridKind::Hierarchical;

    /// A cell splits for a segment shorter than its width divided by 2·`cellPerLength`, into cells at least
    /// `cellPerLength` times as wide as the segment is long.
    HierarchicalGrid(const Box2 &bounds, double cellPerLength);
    static HierarchicalGrid create(const GridRequest &request);

    void insert(const GenerationFront &front, SlotId id);
    void remove(const GenerationFront &front, SlotId id);
    /// See NoGrid::keeps(). Returns true if the segment lies in one cell and stays in it, and the cell does not have to
    /// split.
    bool keeps(SlotId id, Vec2 a, Vec2 b) const;
    /// See NoGrid::moved().
    void moved(const GenerationFront &front, SlotId id);

    /// See NoGrid::query().
    template <class Deliver, class Visited>
    void query(const GenerationFront &, const Box2 &box, Deliver &&deliver, Visited &&visited) const {
        const Box2 grown = box.grown(gridSlack(box));
        queryTable(tableAround(grown), grown, [&](const CellLists::List &list, const CellLayout &in, int i, int j) {
            visited(in.cellBox(i, j));
            blocks_.forEach(list, CellScale(in, i, j)(grown), deliver);
        });
    }

    /// See NoGrid::queryNear().
    template <class Deliver, class Visited>
    std::uint32_t queryNear(const GenerationFront &, const Box2 &box, Deliver &&deliver, Visited &&visited) const {
        std::uint32_t looked = 0;
        const Box2 grown = box.grown(gridSlack(box));
        queryTable(tableAround(grown), grown, [&](const CellLists::List &list, const CellLayout &in, int i, int j) {
            visited(in.cellBox(i, j));
            looked += list.size;
            blocks_.forEachNear(list, CellScale(in, i, j)(box), deliver);
        });
        return looked;
    }

    template <class Cell>
    void forEachCell(Cell &&visit) const {
        for (const Table &table : tables_) {
            for (int j = 0; j < table.layout.rows; ++j) {
                for (int i = 0; i < table.layout.columns; ++i) {
                    const CellContent &content = cells_[cell(table, i, j)];
                    if (content.table == kLeaf) {
                        visit(table.layout.cellBox(i, j), content.list.size);
                    }
                }
            }
        }
    }

  private:
    static constexpr std::uint32_t kLeaf = 0;
    /// A leaf with its list, or the table it was split into, which is never the top table 0.
    struct CellContent {
        CellLists::List list;
        std::uint32_t table = kLeaf;
    };
    struct Table {
        CellLayout layout;
        std::uint32_t firstCell = 0;
        /// The box of the points that belong to this table: the layouts above, whose coordinates may be far larger and
        /// more rounded, all map it to the cells that led here.
        Box2 inner;
        double slack = 0.0; ///< gridSlack() of its box
        std::uint32_t above = 0;
    };
    /// The cell of a segment that crosses only one; kNowhere if it crosses several.
    struct Place {
        static constexpr std::uint32_t kNowhere = kNoIndex;
        std::uint32_t table = kNowhere;
        std::uint32_t cell = 0;
        std::uint8_t i = 0, j = 0;
    };

    static std::uint32_t cell(const Table &table, int i, int j) {
        return table.firstCell + static_cast<std::uint32_t>(j * table.layout.columns + i);
    }
    /// Returns the table to look up a box in: goes up from the last one until it contains the box, then down while one
    /// cell contains it.
    std::uint32_t tableAround(const Box2 &box) const;
    std::uint32_t addTable(const Box2 &box, int columns, int rows, const Box2 &inner, std::uint32_t above);
    bool tooCoarse(const Table &table, double length) const;
    /// Calls visit(i, j) for every cell of the table that the segment of a slot crosses.
    template <class Visit>
    static void forEachCellOf(const Table &table, const GenerationFront &front, SlotId id, Visit &&visit) {
        const double own = gridSlack(boxOf(front.start(id), front.end(id)));
        forEachCrossedCell(table.layout, front.start(id), front.end(id), own, std::max(own, table.slack), visit);
    }
    /// Returns the box of a segment with its slack.
    static Box2 grownBox(const GenerationFront &front, SlotId id) {
        const Box2 box = boxOf(front.start(id), front.end(id));
        return box.grown(gridSlack(box));
    }
    void insertInto(std::uint32_t table, const GenerationFront &front, SlotId id);
    void removeFrom(std::uint32_t table, const GenerationFront &front, SlotId id);
    void split(std::uint32_t above, std::uint32_t cellIndex, const Box2 &box, double length,
               const GenerationFront &front);

    template <class Visit>
    void queryTable(std::uint32_t tableIndex, const Box2 &grown, const Visit &visit) const {
        const Table &table = tables_[tableIndex];
        const CellLayout &layout = table.layout;
        const int i0 = layout.column(grown.min.x);
        const int i1 = layout.column(grown.max.x);
        const int j1 = layout.row(grown.max.y);
        for (int j = layout.row(grown.min.y); j <= j1; ++j) {
            for (int i = i0; i <= i1; ++i) {
                const CellContent &content = cells_[cell(table, i, j)];
                if (content.table == kLeaf) {
                    visit(content.list, layout, i, j);
                } else {
                    queryTable(content.table, grown, visit);
                }
            }
        }
    }

    double cellPerLength_;
    std::vector<Table> tables_;
    std::vector<CellContent> cells_;
    CellLists blocks_;
    std::vector<Place> places_;      ///< per slot
    mutable std::uint32_t last_ = 0; ///< table of the last query, where the next one probably is
    std::uint32_t pushed_ = 0;       ///< cells that the current insertion reached
};

} // namespace forefront
