#pragma once

#include "core/engine/base/hash.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/base/vec2.hpp"

#include <bit>
#include <cstdint>
#include <vector>

namespace forefront {

/// Finds equal places in a list that it appends to: a hash table with open addressing.
class PlaceTable {
  public:
    /// `limit`: maximum number of places looked up.
    explicit PlaceTable(std::size_t limit) : slots_(std::bit_ceil(2 * limit + 2), kNoIndex) {}

    /// Returns the index of the place in the list; appends it if it is new.
    std::uint32_t indexOf(Vec2 p, std::vector<Vec2> &places) {
        Hash64 hash;
        hash.add(p.x);
        hash.add(p.y);
        const std::size_t mask = slots_.size() - 1;
        std::size_t slot = hash.value() & mask;
        while (slots_[slot] != kNoIndex && places[slots_[slot]] != p) {
            slot = (slot + 1) & mask;
        }
        if (slots_[slot] == kNoIndex) {
            slots_[slot] = static_cast<std::uint32_t>(places.size());
            places.push_back(p);
        }
        return slots_[slot];
    }

  private:
    std::vector<std::uint32_t> slots_;
};

} // namespace forefront
