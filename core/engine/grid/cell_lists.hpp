#pragma once

#include "core/engine/base/assert.hpp"
#include "core/engine/grid/segment_block.hpp"

#include <bit>
#include <vector>

namespace forefront {

/// Lists of segments, one per cell, in no particular order. A list is a chain of blocks of a common pool with a free
/// list; all blocks of a chain except the first are full. All boxes of a list are relative to its cell.
class CellLists {
  public:
    static constexpr std::uint32_t kEnd = kNoIndex;

    struct List {
        std::uint32_t head = kEnd;
        std::uint32_t size = 0;
    };

    void push(List &list, SlotId slot, const CellBox &box) {
        const unsigned lane = list.size % SegmentBlock::kWidth;
        if (lane == 0) {
            list.head = allocate(list.head);
        }
        blocks_[list.head].set(lane, slot, box);
        ++list.size;
    }

    void erase(List &list, SlotId slot) {
        const Entry found = find(list, slot);
        FOREFRONT_ASSERT(found.block != kEnd);
        if (found.block == kEnd) {
            return;
        }
        const unsigned last = --list.size % SegmentBlock::kWidth;
        blocks_[found.block].copy(found.lane, blocks_[list.head], last);
        if (last == 0) {
            const std::uint32_t next = next_[list.head];
            next_[list.head] = free_;
            free_ = list.head;
            list.head = next;
        }
    }

    /// Changes the box of an entry.
    void move(const List &list, SlotId slot, const CellBox &box) {
        const Entry found = find(list, slot);
        FOREFRONT_ASSERT(found.block != kEnd);
        if (found.block != kEnd) {
            blocks_[found.block].set(found.lane, slot, box);
        }
    }

    template <class Visit>
    void forEach(const List &list, Visit &&visit) const {
        forEachBlock(list, [&](const SegmentBlock &block, unsigned entries) {
            for (unsigned lane = 0; lane < entries; ++lane) {
                visit(block.slots[lane]);
            }
        });
    }

    /// Calls visit(slot, overlaps) for all entries; `overlaps`: their box overlaps the given one.
    template <class Visit>
    void forEach(const List &list, const CellBox &box, Visit &&visit) const {
        forEachBlock(list, [&](const SegmentBlock &block, unsigned entries) {
            const unsigned near = block.overlapping(box);
            for (unsigned lane = 0; lane < entries; ++lane) {
                visit(block.slots[lane], (near >> lane & 1U) != 0);
            }
        });
    }

    /// Calls visit(slot) for the entries whose boxes overlap the given one.
    template <class Visit>
    void forEachNear(const List &list, const CellBox &box, Visit &&visit) const {
        forEachBlock(list, [&](const SegmentBlock &block, unsigned entries) {
            for (unsigned near = block.overlapping(box) & firstLanes(entries); near != 0; near &= near - 1) {
                visit(block.slots[static_cast<unsigned>(std::countr_zero(near))]);
            }
        });
    }

  private:
    struct Entry {
        std::uint32_t block;
        unsigned lane;
    };

    /// Returns the number of entries of the first block of a non-empty list.
    static unsigned inFirst(const List &list) { return (list.size - 1) % SegmentBlock::kWidth + 1; }

    static unsigned firstLanes(unsigned entries) { return (1U << entries) - 1U; }

    /// Calls visit(block, number of entries) for all blocks of a list.
    template <class Visit>
    void forEachBlock(const List &list, const Visit &visit) const {
        unsigned entries = inFirst(list);
        for (std::uint32_t block = list.head; block != kEnd; block = next_[block]) {
            visit(blocks_[block], entries);
            entries = SegmentBlock::kWidth;
        }
    }

    Entry find(const List &list, SlotId slot) const {
        unsigned entries = inFirst(list);
        for (std::uint32_t block = list.head; block != kEnd; block = next_[block]) {
            const unsigned lanes = blocks_[block].holding(slot) & firstLanes(entries);
            if (lanes != 0) {
                return {block, static_cast<unsigned>(std::countr_zero(lanes))};
            }
            entries = SegmentBlock::kWidth;
        }
        return {kEnd, 0};
    }

    std::uint32_t allocate(std::uint32_t next) {
        std::uint32_t block = free_;
        if (block == kEnd) {
            block = static_cast<std::uint32_t>(blocks_.size());
            blocks_.emplace_back();
            next_.push_back(next);
        } else {
            free_ = next_[block];
            next_[block] = next;
        }
        return block;
    }

    std::vector<SegmentBlock> blocks_;
    std::vector<std::uint32_t> next_; ///< per block
    std::uint32_t free_ = kEnd;
};

} // namespace forefront
