#pragma once

#include "core/front/generation_front.hpp"
#include "core/grid/grid_kind.hpp"

namespace forefront {

/// No background grid: every search looks at all of Γ. The oracle for the other grids.
class NoGrid {
  public:
    static constexpr GridKind kKind = GridKind::None;

    void insert(const GenerationFront &, SlotId) {}
    void remove(const GenerationFront &, SlotId) {}
    /// True if the segment of a slot may become ab without being removed and inserted again.
    bool keeps(SlotId, Vec2, Vec2) const { return true; }
    /// A segment that could be kept has become another.
    void moved(const GenerationFront &, SlotId) {}

    /// Calls deliver(slot, near), at least once, for every front segment (and isolated point) that comes near `box` by
    /// the grid's slack, and for others of the cells looked into, which may have near = false; and visited(cell box)
    /// for every such cell.
    template <class Deliver, class Visited>
    void query(const GenerationFront &front, const Box2 &, Deliver &&deliver, Visited &&) const {
        for (std::uint32_t i = 0; i < front.capacity(); ++i) {
            if (front[SlotId{i}].alive) {
                deliver(SlotId{i}, true);
            }
        }
    }

    /// Calls deliver(slot), at least once, for every front segment (and isolated point) that meets `box`, among them
    /// some that do not, but whose own box comes within 1/256 of a cell of it, or of where it is moved to from outside
    /// the grid; and visited(cell box) for every cell looked into. Returns the number of segments looked at.
    template <class Deliver, class Visited>
    std::uint32_t queryNear(const GenerationFront &front, const Box2 &box, Deliver &&deliver, Visited &&) const {
        std::uint32_t looked = 0;
        for (std::uint32_t i = 0; i < front.capacity(); ++i) {
            const SlotId id{i};
            if (front[id].alive) {
                ++looked;
                if (box.overlaps(boxOf(front.start(id), front.end(id)))) {
                    deliver(id);
                }
            }
        }
        return looked;
    }

    /// Calls cell(box, entries) for every cell of the grid.
    template <class Cell>
    void forEachCell(Cell &&) const {}
};

} // namespace forefront
