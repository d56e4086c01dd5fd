#pragma once

#include "core/base/assert.hpp"
#include "core/base/ids.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Singly linked lists of slots, one a cell, in one pool with a free list.
class CellLists {
  public:
    static constexpr std::uint32_t kEnd = kNoIndex;

    void push(std::uint32_t &head, SlotId slot) {
        std::uint32_t entry = free_;
        if (entry == kEnd) {
            entry = static_cast<std::uint32_t>(entries_.size());
            entries_.push_back({});
        } else {
            free_ = entries_[entry].next;
        }
        entries_[entry] = {slot, head};
        head = entry;
    }

    void erase(std::uint32_t &head, SlotId slot) {
        std::uint32_t *link = &head;
        while (*link != kEnd && entries_[*link].slot != slot) {
            link = &entries_[*link].next;
        }
        FOREFRONT_ASSERT(*link != kEnd);
        if (*link == kEnd) {
            return;
        }
        const std::uint32_t entry = *link;
        *link = entries_[entry].next;
        entries_[entry].next = free_;
        free_ = entry;
    }

    template <class Visit>
    void forEach(std::uint32_t head, Visit &&visit) const {
        for (std::uint32_t entry = head; entry != kEnd; entry = entries_[entry].next) {
            visit(entries_[entry].slot);
        }
    }

    std::uint32_t count(std::uint32_t head) const {
        std::uint32_t n = 0;
        forEach(head, [&](SlotId) { ++n; });
        return n;
    }

  private:
    struct Entry {
        SlotId slot = kNoSlot;
        std::uint32_t next = kEnd;
    };
    std::vector<Entry> entries_;
    std::uint32_t free_ = kEnd;
};

} // namespace forefront
