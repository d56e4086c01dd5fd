#pragma once

#include "core/front/generation_front.hpp"

#include <array>
#include <vector>

namespace forefront {

/// Which segment of Γ is the next base: of the lowest failure class the shortest, ties by serial. Among those never
/// deferred that alone would jump to and fro over a large front, and what a step needs would have left the caches. So
/// their lengths count as equal if the first five binary digits are the same, hence within 1/16, and of equal ones
/// those of the oldest portion come first, the shortest before the others; a portion is so many segments made one after
/// the other that it fits in a cache. Up to some 10,000 elements there is only one. On Lo's rows this lowers the
/// exponent of the cost in Ne from 1.05 to 1.035 at the same quality; a uniform disc of 1e6 falls from α .997 to .995.
///
/// One binary heap for each class of lengths, so that its depth does not grow with Γ; entries of segments that are gone
/// or were deferred since are skipped when they come up. What it delivers depends on Γ alone, not on the history of the
/// heaps, so stepping back only needs to offer the restored segments again.
class BaseOrder {
  public:
    /// Offers every segment of the front.
    void rebuild(const GenerationFront &front);
    void offer(const GenerationFront &front, SlotId id);
    /// The next base, taken out; kNoSlot when Γ = ∅.
    SlotId take(const GenerationFront &front);
    /// The next base without taking it.
    SlotId peek(const GenerationFront &front);

  private:
    struct Entry {
        std::uint64_t length; ///< its bits: positive doubles compare as their bits do
        std::uint32_t serial;
        SlotId slot;
    };
    using Heap = std::vector<Entry>;
    static constexpr unsigned kPortionBits = 14; ///< low bits of a serial, those of its place in the portion
    static constexpr unsigned kDigits = 4;       ///< of the mantissa of a length, beside the leading one
    /// Exponent and first digits of a length; then the failure classes, from 1, the last for all greater.
    static constexpr std::size_t kDeferred = std::size_t{1} << (11U + kDigits);
    static constexpr std::size_t kFailureClasses = 64;
    static constexpr std::size_t kClasses = kDeferred + kFailureClasses;

    /// Order of the heap of a class.
    struct ComesLater {
        bool byPortions;
        bool operator()(const Entry &a, const Entry &b) const;
    };
    static ComesLater orderOf(std::size_t c) { return {c < kDeferred}; }
    static bool valid(const GenerationFront &front, const Entry &entry, std::size_t entryClass);
    static std::size_t classOf(const FrontSlot &slot);
    std::size_t lowestClass() const;
    void push(const GenerationFront &front, SlotId id);
    /// The heap whose top is the next base; null when there is none.
    Heap *next(const GenerationFront &front);
    void pop(Heap &heap);

    std::vector<std::uint32_t> heapOf_; ///< per class: its heap, from 1; 0: none yet
    std::vector<Heap> heaps_;
    std::vector<std::uint32_t> classOf_;                          ///< per heap
    std::vector<std::uint64_t> filled_;                           ///< bit per class that has entries
    std::array<std::uint64_t, kClasses / 64 / 64 + 1> summary_{}; ///< bit per word of filled_ that is not 0
    std::size_t entries_ = 0;
};

} // namespace forefront
