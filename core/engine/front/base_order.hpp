#pragma once

#include "core/engine/front/base_rule.hpp"
#include "core/engine/front/generation_front.hpp"

#include <array>
#include <vector>

namespace forefront {

/// How bases are ordered.
struct BaseOrdering {
    BaseRule rule = BaseRule::Shortest;
    std::uint32_t seed = 0; ///< of BaseRule::Random

    /// Returns a key of a segment: the base is the one with the least among those of the lowest failure class, and of
    /// equal ones the oldest. Lengths that differ only by rounding have the same key.
    std::int64_t keyOf(const FrontSlot &slot) const;
};

/// Selects the next base: by default the shortest segment of the lowest failure class, the oldest of equal ones.
/// Lengths are compared by orderKey(), so that those that differ only by rounding are equal.
///
/// On a large front the shortest segments are scattered, and their surroundings would not be in the caches. So segments
/// that were never deferred are taken in batches by age: lengths are similar if their first five binary digits are
/// the same, hence within 1/16, and of similar ones the oldest batch comes first, with its shortest segment first. A
/// batch is a number of consecutive segments that fit in a cache; up to about 10,000 elements there is only one. On
/// Lo's rows this lowers the exponent of the cost in Ne from 1.05 to 1.035 at the same quality; α of a uniform disc of
/// 1e6 elements falls from .997 to .995. The same holds for the longest first. Orders that do not go by length have one
/// class and no batches.
///
/// There is one binary heap for each length class, so that its depth does not grow with Γ. Entries of segments that are
/// gone or were deferred since are skipped. The result depends on Γ alone, not on the history of the heaps, so stepping
/// back only needs to offer the restored segments again.
class BaseOrder {
  public:
    explicit BaseOrder(const BaseOrdering &ordering = {}) : ordering_(ordering) {}

    /// Offers every segment of the front.
    void rebuild(const GenerationFront &front);
    /// Adds a segment.
    void offer(const GenerationFront &front, SlotId id);
    /// Removes and returns the next base; kNoSlot when Γ = ∅.
    SlotId take(const GenerationFront &front);
    /// Returns the next base without removing it.
    SlotId peek(const GenerationFront &front);

  private:
    struct Entry {
        std::int64_t key; ///< BaseOrdering::keyOf()
        std::uint32_t serial;
        SlotId slot;
    };
    using Heap = std::vector<Entry>;
    static constexpr unsigned kBatchBits = 14; ///< low bits of a serial: its position in the batch
    static constexpr unsigned kDigits = 4;     ///< digits of the mantissa of a length, besides the leading one
    /// Classes by exponent and first digits of a length, then by failure class from 1 on; the last is for all higher
    /// ones.
    static constexpr std::size_t kDeferred = std::size_t{1} << (11U + kDigits);
    static constexpr std::size_t kFailureClasses = 64;
    static constexpr std::size_t kClasses = kDeferred + kFailureClasses;

    /// The order of the heap of a class.
    struct ComesLater {
        bool byBatches;
        bool operator()(const Entry &a, const Entry &b) const;
    };
    bool byLength() const { return ordering_.rule == BaseRule::Shortest || ordering_.rule == BaseRule::Longest; }
    ComesLater orderOf(std::size_t c) const { return {c < kDeferred && byLength()}; }
    bool valid(const GenerationFront &front, const Entry &entry, std::size_t entryClass) const;
    std::size_t classOf(const FrontSlot &slot) const;
    std::size_t lowestClass() const;
    void push(const GenerationFront &front, SlotId id);
    /// Returns the heap whose top is the next base; null if there is none.
    Heap *next(const GenerationFront &front);
    void pop(Heap &heap);

    BaseOrdering ordering_;
    std::vector<std::uint32_t> heapOf_; ///< per class: its heap, from 1; 0: none yet
    std::vector<Heap> heaps_;
    std::vector<std::uint32_t> classOf_;                          ///< per heap
    std::vector<std::uint64_t> filled_;                           ///< bit per class that has entries
    std::array<std::uint64_t, kClasses / 64 / 64 + 1> summary_{}; ///< bit per word of filled_ that is not 0
    std::size_t entries_ = 0;
};

/// The segments that BaseOrder chooses a base from by age.
struct FirstBases {
    std::size_t equal = 0;        ///< with the key of the base and as often deferred; the base is one of them
    bool earlierDeferred = false; ///< a segment with a lower key waits that was deferred more often
};
/// Returns the segments that come first with a base; none if a segment comes before it by failure class and key, as on
/// a large front. Looks at all of Γ.
FirstBases firstBases(const GenerationFront &front, const BaseOrdering &ordering, SlotId base);

} // namespace forefront
