#pragma once

#include "core/front/generation_front.hpp"

#include <vector>

namespace forefront {

/// Which segment of Γ is the next base: of the lowest failure class the shortest, ties by serial. A binary heap in
/// which entries of segments that are gone or were deferred since are skipped when they come up. What it delivers
/// depends on Γ alone, not on the history of the heap, so stepping back only needs to offer the restored segments
/// again.
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
        double length;
        SegmentMark mark;
        SlotId slot;
    };
    static bool comesLater(const Entry &a, const Entry &b);
    static bool valid(const GenerationFront &front, const Entry &entry);

    std::vector<Entry> heap_;
};

} // namespace forefront
