#pragma once

#include "core/engine/front/generation_front.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace forefront {

/// The order of the bases of the two-coloured front: diagonals first, the newest one first, since their second halves
/// complete squares; then legs by class of node spacing, smallest first, and within a class row by row, in the order
/// in which they were made.
///
/// Rows from the boundary meet in the middle of the domain. If there is a limit on their number, deeper legs wait until
/// no others are left. Then one of them starts a lattice that grows through the rest of the domain.
class FrontLayers {
  public:
    static constexpr std::uint32_t kAllRows = std::numeric_limits<std::uint32_t>::max();

    /// `rows`: number of rows along the boundary before the lattice grows.
    explicit FrontLayers(std::uint32_t rows = kAllRows) : rows_(rows) {}

    void offerDiagonal(const GenerationFront &front, SlotId id) { diagonals_.push_back(entry(front, id)); }
    /// Offers a diagonal that no apex was found for, behind all others.
    void deferDiagonal(const GenerationFront &front, SlotId id) { late_.push_back(entry(front, id)); }
    void offerLeg(const GenerationFront &front, SlotId id, std::uint32_t layer);
    /// Returns the next base and removes it; kNoSlot: there is none.
    SlotId take(const GenerationFront &front);
    /// Returns the row that a segment was offered for.
    std::uint32_t layerOf(SlotId id) const { return index(id) < layers_.size() ? layers_[index(id)] : 0; }
    void setLayer(SlotId id, std::uint32_t layer);

  private:
    struct Entry {
        SlotId id;
        std::uint32_t serial;
    };
    /// First in, first out.
    struct Queue {
        std::vector<Entry> entries;
        std::size_t head = 0;
    };
    struct Key {
        int spacingClass;
        std::uint32_t layer;
        friend auto operator<=>(const Key &, const Key &) = default;
    };

    static Entry entry(const GenerationFront &front, SlotId id) { return {id, front[id].mark.serial}; }
    static bool isCurrent(const GenerationFront &front, const Entry &e) {
        return front[e.id].alive && front[e.id].mark.serial == e.serial;
    }
    static SlotId takeFrom(std::map<Key, Queue> &queues, const GenerationFront &front);
    static SlotId takeNewest(std::vector<Entry> &entries, const GenerationFront &front);

    std::uint32_t rows_;
    bool lattice_ = false; ///< it has started to grow
    std::vector<Entry> diagonals_, late_;
    std::map<Key, Queue> legs_, waiting_;
    std::vector<std::uint32_t> layers_; ///< per slot
};

} // namespace forefront
