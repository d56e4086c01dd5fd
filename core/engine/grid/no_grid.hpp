#pragma once

#include "core/engine/front/generation_front.hpp"
#include "core/engine/grid/grid_kind.hpp"
#include "core/engine/grid/grid_request.hpp"

namespace forefront {

/// No background grid: every search looks at all of Γ. It is the reference that the other grids are tested against.
class NoGrid {
  public:
    static constexpr GridKind kKind = GridKind::None;

    static NoGrid create(const GridRequest &) { return {}; }

    void insert(const GenerationFront &, SlotId) {}
    void remove(const GenerationFront &, SlotId) {}
    /// Returns true if the segment of a slot may become ab without being removed and inserted again.
    bool keeps(SlotId, Vec2, Vec2) const { return true; }
    /// Updates a segment that changed and for which keeps() was true.
    void moved(const GenerationFront &, SlotId) {}

    /// Calls deliver(slot, near), at least once, for every front segment and isolated point within the slack of the
    /// grid of `box`. It may be called for other segments of the visited cells, possibly with near = false. Calls
    /// visited(cell box) for every visited cell.
    template <class Deliver, class Visited>
    void query(const GenerationFront &front, const Box2 &, Deliver &&deliver, Visited &&) const {
        for (std::uint32_t i = 0; i < front.capacity(); ++i) {
            if (front[SlotId{i}].alive) {
                deliver(SlotId{i}, true);
            }
        }
    }

    /// Calls deliver(slot), at least once, for every front segment and isolated point that meets `box`, and possibly
    /// for some whose box is within 1/256 of a cell of it; boxes outside the grid are moved to its edge. Calls
    /// visited(cell box) for every visited cell. Returns the number of segments examined.
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
