#pragma once

#include "core/engine/front/generation_front.hpp"
#include "core/engine/grid/cell_layout.hpp"
#include "core/engine/grid/cell_lists.hpp"
#include "core/engine/grid/grid_kind.hpp"
#include "core/engine/grid/grid_request.hpp"

#include <vector>

namespace forefront {

/// Lo's dynamic background grid: columns x rows of equal cells. Each cell lists the segments of Γ that cross it;
/// segments are added and deleted as Γ evolves.
class UniformGrid {
  public:
    static constexpr GridKind kKind = GridKind::Uniform;

    UniformGrid(const Box2 &bounds, int columns, int rows);
    /// Creates a grid with the requested cells, or with cells about three mean node spacings wide.
    static UniformGrid create(const GridRequest &request);

    void insert(const GenerationFront &front, SlotId id);
    void remove(const GenerationFront &front, SlotId id);
    /// See NoGrid::keeps(). Always returns false, without checking.
    bool keeps(SlotId, Vec2, Vec2) const { return false; }
    void moved(const GenerationFront &, SlotId) {}

    /// See NoGrid::query().
    template <class Deliver, class Visited>
    void query(const GenerationFront &, const Box2 &box, Deliver &&deliver, Visited &&visited) const {
        const Box2 grown = withSlack(box);
        forEachCellNear(grown, [&](const CellLists::List &list, int i, int j) {
            visited(layout_.cellBox(i, j));
            blocks_.forEach(list, CellScale(layout_, i, j)(grown), deliver);
        });
    }

    /// See NoGrid::queryNear().
    template <class Deliver, class Visited>
    std::uint32_t queryNear(const GenerationFront &, const Box2 &box, Deliver &&deliver, Visited &&visited) const {
        std::uint32_t looked = 0;
        forEachCellNear(withSlack(box), [&](const CellLists::List &list, int i, int j) {
            visited(layout_.cellBox(i, j));
            looked += list.size;
            blocks_.forEachNear(list, CellScale(layout_, i, j)(box), deliver);
        });
        return looked;
    }

    template <class Cell>
    void forEachCell(Cell &&visit) const {
        for (int j = 0; j < layout_.rows; ++j) {
            for (int i = 0; i < layout_.columns; ++i) {
                visit(layout_.cellBox(i, j), lists_[cell(i, j)].size);
            }
        }
    }

  private:
    std::size_t cell(int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(layout_.columns) + static_cast<std::size_t>(i);
    }

    Box2 withSlack(const Box2 &box) const { return box.grown(std::max(slack_, gridSlack(box))); }

    template <class Visit>
    void forEachCellNear(const Box2 &grown, Visit &&visit) const {
        const int i0 = layout_.column(grown.min.x);
        const int i1 = layout_.column(grown.max.x);
        const int j1 = layout_.row(grown.max.y);
        for (int j = layout_.row(grown.min.y); j <= j1; ++j) {
            for (int i = i0; i <= i1; ++i) {
                visit(lists_[cell(i, j)], i, j);
            }
        }
    }

    CellLayout layout_;
    double slack_;
    std::vector<CellLists::List> lists_;
    CellLists blocks_;
};

} // namespace forefront
