#include "core/front/base_order.hpp"

#include <algorithm>

namespace forefront {

bool BaseOrder::comesLater(const Entry &a, const Entry &b) {
    if (a.mark.failureClass != b.mark.failureClass) {
        return a.mark.failureClass > b.mark.failureClass;
    }
    if (a.length != b.length) {
        return a.length > b.length;
    }
    return a.mark.serial > b.mark.serial;
}

bool BaseOrder::valid(const GenerationFront &front, const Entry &entry) {
    const FrontSlot &slot = front[entry.slot];
    return slot.alive && slot.mark.serial == entry.mark.serial && slot.mark.failureClass == entry.mark.failureClass;
}

void BaseOrder::rebuild(const GenerationFront &front) {
    heap_.clear();
    for (std::uint32_t i = 0; i < front.capacity(); ++i) {
        const SlotId id{i};
        if (front[id].alive && !front.isolated(id)) {
            heap_.push_back({front[id].length, front[id].mark, id});
        }
    }
    std::make_heap(heap_.begin(), heap_.end(), comesLater);
}

void BaseOrder::offer(const GenerationFront &front, SlotId id) {
    // Stepping back and forth leaves duplicates behind; they are swept out before they outweigh the front.
    if (heap_.size() > 4 * front.segments() + 1024) {
        rebuild(front);
        return;
    }
    heap_.push_back({front[id].length, front[id].mark, id});
    std::push_heap(heap_.begin(), heap_.end(), comesLater);
}

SlotId BaseOrder::peek(const GenerationFront &front) {
    while (!heap_.empty() && !valid(front, heap_.front())) {
        std::pop_heap(heap_.begin(), heap_.end(), comesLater);
        heap_.pop_back();
    }
    return heap_.empty() ? kNoSlot : heap_.front().slot;
}

SlotId BaseOrder::take(const GenerationFront &front) {
    const SlotId id = peek(front);
    if (id != kNoSlot) {
        std::pop_heap(heap_.begin(), heap_.end(), comesLater);
        heap_.pop_back();
    }
    return id;
}

} // namespace forefront
