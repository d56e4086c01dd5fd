#include "core/engine/front/base_order.hpp"

#include "core/engine/base/hash.hpp"
#include "core/engine/front/order_key.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace forefront {

std::int64_t BaseOrdering::keyOf(const FrontSlot &slot) const {
    switch (rule) {
    case BaseRule::Shortest:
        return orderKey(slot.length);
    case BaseRule::Longest:
        return -orderKey(slot.length);
    case BaseRule::Oldest:
        return slot.mark.serial;
    case BaseRule::Random:
        break;
    }
    Hash64 drawn;
    drawn.add(static_cast<std::uint64_t>(seed));
    drawn.add(static_cast<std::uint64_t>(slot.mark.serial));
    return static_cast<std::int64_t>(drawn.value() >> 1U);
}

bool BaseOrder::ComesLater::operator()(const Entry &a, const Entry &b) const {
    const std::uint32_t batchA = a.serial >> kBatchBits, batchB = b.serial >> kBatchBits;
    if (byBatches && batchA != batchB) {
        return batchA > batchB;
    }
    return a.key != b.key ? a.key > b.key : a.serial > b.serial;
}

bool BaseOrder::valid(const GenerationFront &front, const Entry &entry, std::size_t entryClass) const {
    const FrontSlot &slot = front[entry.slot];
    return slot.alive && slot.mark.serial == entry.serial && classOf(slot) == entryClass;
}

std::size_t BaseOrder::classOf(const FrontSlot &slot) const {
    constexpr unsigned kDroppedBits = 52 - kTieBits - kDigits;
    if (slot.mark.failureClass > 0) {
        return kDeferred + std::min<std::size_t>(slot.mark.failureClass, kFailureClasses) - 1;
    }
    if (!byLength()) {
        return 0;
    }
    const auto lengthClass = static_cast<std::size_t>(orderKey(slot.length) >> kDroppedBits);
    return ordering_.rule == BaseRule::Shortest ? lengthClass : kDeferred - 1 - lengthClass;
}

std::size_t BaseOrder::lowestClass() const {
    for (std::size_t s = 0; s < summary_.size(); ++s) {
        if (summary_[s] != 0) {
            const std::size_t word = s * 64 + static_cast<std::size_t>(std::countr_zero(summary_[s]));
            return word * 64 + static_cast<std::size_t>(std::countr_zero(filled_[word]));
        }
    }
    return kClasses;
}

void BaseOrder::push(const GenerationFront &front, SlotId id) {
    const FrontSlot &slot = front[id];
    const std::size_t c = classOf(slot);
    if (heapOf_[c] == 0) {
        heaps_.emplace_back();
        classOf_.push_back(static_cast<std::uint32_t>(c));
        heapOf_[c] = static_cast<std::uint32_t>(heaps_.size());
    }
    Heap &heap = heaps_[heapOf_[c] - 1U];
    heap.push_back({ordering_.keyOf(slot), slot.mark.serial, id});
    std::push_heap(heap.begin(), heap.end(), orderOf(c));
    filled_[c / 64] |= std::uint64_t{1} << (c % 64);
    summary_[c / 64 / 64] |= std::uint64_t{1} << (c / 64 % 64);
    ++entries_;
}

void BaseOrder::pop(Heap &heap) {
    const std::size_t c = classOf_[static_cast<std::size_t>(&heap - heaps_.data())];
    std::pop_heap(heap.begin(), heap.end(), orderOf(c));
    heap.pop_back();
    --entries_;
    if (heap.empty()) {
        filled_[c / 64] &= ~(std::uint64_t{1} << (c % 64));
        if (filled_[c / 64] == 0) {
            summary_[c / 64 / 64] &= ~(std::uint64_t{1} << (c / 64 % 64));
        }
    }
}

void BaseOrder::rebuild(const GenerationFront &front) {
    heapOf_.assign(kClasses, 0);
    filled_.assign(kClasses / 64, 0);
    summary_.fill(0);
    heaps_.clear();
    classOf_.clear();
    entries_ = 0;
    for (std::uint32_t i = 0; i < front.capacity(); ++i) {
        const SlotId id{i};
        if (front[id].alive && !front.isolated(id)) {
            push(front, id);
        }
    }
}

void BaseOrder::offer(const GenerationFront &front, SlotId id) {
    // Stepping back and forth leaves duplicates, which are removed before they outnumber the front.
    if (entries_ > 4 * front.segments() + 1024) {
        rebuild(front);
        return;
    }
    push(front, id);
}

BaseOrder::Heap *BaseOrder::next(const GenerationFront &front) {
    for (std::size_t c = lowestClass(); c < kClasses; c = lowestClass()) {
        Heap &heap = heaps_[heapOf_[c] - 1U];
        while (!heap.empty() && !valid(front, heap.front(), c)) {
            pop(heap);
        }
        if (!heap.empty()) {
            return &heap;
        }
    }
    return nullptr;
}

SlotId BaseOrder::peek(const GenerationFront &front) {
    const Heap *heap = next(front);
    return heap == nullptr ? kNoSlot : heap->front().slot;
}

SlotId BaseOrder::take(const GenerationFront &front) {
    Heap *heap = next(front);
    if (heap == nullptr) {
        return kNoSlot;
    }
    const SlotId id = heap->front().slot;
    pop(*heap);
    if (!heap->empty()) { // probably the base after this one, and far from it in memory
        __builtin_prefetch(&front[heap->front().slot]);
    }
    return id;
}

FirstBases firstBases(const GenerationFront &front, const BaseOrdering &ordering, SlotId base) {
    const std::uint32_t baseClass = front[base].mark.failureClass;
    const std::int64_t baseKey = ordering.keyOf(front[base]);
    FirstBases found;
    bool first = true;
    for (std::uint32_t i = 0; i < front.capacity(); ++i) {
        const SlotId id{i};
        if (!front[id].alive || front.isolated(id)) {
            continue;
        }
        const std::uint32_t failureClass = front[id].mark.failureClass;
        const std::int64_t key = ordering.keyOf(front[id]);
        first = first && std::pair{failureClass, key} >= std::pair{baseClass, baseKey};
        found.equal += failureClass == baseClass && key == baseKey ? 1U : 0U;
        found.earlierDeferred = found.earlierDeferred || (failureClass > baseClass && key < baseKey);
    }
    return first ? found : FirstBases{};
}

} // namespace forefront
