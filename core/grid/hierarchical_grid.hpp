#pragma once

#include "core/front/generation_front.hpp"
#include "core/grid/cell_lists.hpp"
#include "core/grid/grid_kind.hpp"
#include "core/grid/cell_layout.hpp"

#include <vector>

namespace forefront {

/// A background grid whose cells follow the lengths of the front segments. Coarse cells on top; a cell splits, once and
/// for all, into n x n when a segment much shorter than the cell enters it. So the number of segments delivered stays
/// flat at any ratio of sizes.
class HierarchicalGrid {
  public:
    static constexpr GridKind kKind = GridKind::Hierarchical;

    /// `slack`: at least gridSlack() of all that will be inserted. A cell splits for a segment shorter than half of
    /// 1/`cellPerLength` of its width, into cells of at least that length times `cellPerLength`.
    HierarchicalGrid(const Box2 &bounds, double slack, double cellPerLength);

    void insert(const GenerationFront &front, SlotId id);
    void remove(const GenerationFront &front, SlotId id);
    /// As NoGrid::keeps: where the segment lies in one cell and stays there, and the cell need not split.
    bool keeps(SlotId id, Vec2 a, Vec2 b) const;
    /// As NoGrid::moved.
    void moved(const GenerationFront &front, SlotId id);

    /// As NoGrid::query.
    template <class Deliver, class Visited>
    void query(const GenerationFront &, const Box2 &box, Deliver &&deliver, Visited &&visited) const {
        const Box2 grown = box.grown(slack_);
        queryTable(tableAround(grown), box, [&](const CellLists::List &list, const CellLayout &in, int i, int j) {
            visited(in.cellBox(i, j));
            blocks_.forEach(list, CellScale(in, i, j)(grown), deliver);
        });
    }

    /// As NoGrid::queryNear.
    template <class Deliver, class Visited>
    std::uint32_t queryNear(const GenerationFront &, const Box2 &box, Deliver &&deliver, Visited &&visited) const {
        std::uint32_t looked = 0;
        queryTable(tableAround(box.grown(slack_)), box,
                   [&](const CellLists::List &list, const CellLayout &in, int i, int j) {
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
    /// A leaf with its list, or the table it was split into (the top table 0 is nobody's child).
    struct CellContent {
        CellLists::List list;
        std::uint32_t table = kLeaf;
    };
    struct Table {
        CellLayout layout;
        std::uint32_t firstCell = 0;
        Box2 inner; ///< its box less a margin: that of the cell above may differ by rounding
        std::uint32_t above = 0;
    };
    /// The only cell that a segment crosses; kNowhere: it crosses several.
    struct Place {
        static constexpr std::uint32_t kNowhere = kNoIndex;
        std::uint32_t table = kNowhere;
        std::uint32_t cell = 0;
        std::uint8_t i = 0, j = 0;
    };

    static std::uint32_t cell(const Table &table, int i, int j) {
        return table.firstCell + static_cast<std::uint32_t>(j * table.layout.columns + i);
    }
    /// The table to look up a box in: from the last one up until it holds the box, and down while all of the box lies
    /// in one cell.
    std::uint32_t tableAround(const Box2 &box) const;
    std::uint32_t addTable(const Box2 &box, int columns, int rows, std::uint32_t above);
    bool tooCoarse(const CellLayout &layout, double length) const;
    void insertInto(std::uint32_t table, const GenerationFront &front, SlotId id);
    void removeFrom(std::uint32_t table, const GenerationFront &front, SlotId id);
    void split(std::uint32_t above, std::uint32_t cellIndex, const Box2 &box, double length,
               const GenerationFront &front);

    template <class Visit>
    void queryTable(std::uint32_t tableIndex, const Box2 &box, const Visit &visit) const {
        const Table &table = tables_[tableIndex];
        const CellLayout &layout = table.layout;
        const int i0 = layout.column(box.min.x - slack_);
        const int i1 = layout.column(box.max.x + slack_);
        const int j1 = layout.row(box.max.y + slack_);
        for (int j = layout.row(box.min.y - slack_); j <= j1; ++j) {
            for (int i = i0; i <= i1; ++i) {
                const CellContent &content = cells_[cell(table, i, j)];
                if (content.table == kLeaf) {
                    visit(content.list, layout, i, j);
                } else {
                    queryTable(content.table, box, visit);
                }
            }
        }
    }

    double slack_;
    double cellPerLength_;
    std::vector<Table> tables_;
    std::vector<CellContent> cells_;
    CellLists blocks_;
    std::vector<Place> places_;      ///< per slot
    mutable std::uint32_t last_ = 0; ///< table of the last look-up: the next one is likely to be there, too
    std::uint32_t pushed_ = 0;       ///< cells that the present insertion has reached
};

} // namespace forefront
