#pragma once

#include "core/front/generation_front.hpp"

#include <string_view>

namespace forefront {

/// No background grid: every search looks at all of Γ. The oracle for the other grids.
class NoGrid {
  public:
    static constexpr std::string_view kName = "none";

    void insert(const GenerationFront &, SlotId) {}
    void remove(const GenerationFront &, SlotId) {}
    /// True if the segment of a slot may become ab without being removed and inserted again.
    bool keeps(SlotId, Vec2, Vec2) const { return true; }

    /// Calls deliver(slot) for every front segment (and isolated point) near `box`, and visited(cell box) for every
    /// cell looked into.
    template <class Deliver, class Visited>
    void query(const GenerationFront &front, const Box2 &, Deliver &&deliver, Visited &&) const {
        for (std::uint32_t i = 0; i < front.capacity(); ++i) {
            if (front[SlotId{i}].alive) {
                deliver(SlotId{i});
            }
        }
    }

    /// Calls cell(box, entries) for every cell of the grid.
    template <class Cell>
    void forEachCell(Cell &&) const {}
};

} // namespace forefront
