#include "core/engine/front/generation_front.hpp"

#include <algorithm>

namespace forefront {

FrontPart GenerationFront::part(std::span<const SlotId> slots) const {
    FrontPart part;
    std::vector<SlotId> &origin = part.origin;
    for (const SlotId id : slots) {
        origin.push_back(id);
        if (!isolated(id)) {
            origin.push_back(next(id));
            ++part.segments;
        }
    }
    std::sort(origin.begin(), origin.end());
    origin.erase(std::unique(origin.begin(), origin.end()), origin.end());
    const auto inPart = [&](SlotId id) {
        const auto at = std::lower_bound(origin.begin(), origin.end(), id);
        return at != origin.end() && *at == id ? SlotId{static_cast<std::uint32_t>(at - origin.begin())} : kNoSlot;
    };
    part.front.slots_.reserve(origin.size() + origin.size() / 2);
    for (const SlotId id : origin) {
        FrontSlot slot = slots_[index(id)];
        slot.next = inPart(slot.next);
        slot.prev = inPart(slot.prev);
        part.front.slots_.push_back(slot);
    }
    part.front.segments_ = part.segments;
    part.front.nextSerial_ = nextSerial_;
    return part;
}

void GenerationFront::adopt(const FrontPart &part, const Box2 &box, std::uint32_t firstNew, std::uint32_t shift) {
    const std::vector<FrontSlot> &slots = part.front.slots_;
    const std::vector<SlotId> &origin = part.origin;
    std::vector<SlotId> here(slots.size(), kNoSlot);
    std::vector<std::uint8_t> owned(slots.size(), 1);
    for (std::size_t i = 0; i < origin.size(); ++i) {
        here[i] = origin[i];
        owned[i] = box.containsHalfOpen(start(origin[i])) ? 1 : 0;
    }
    for (std::size_t i = origin.size(); i < slots.size(); ++i) {
        if (slots[i].alive) {
            here[i] = allocate();
        }
    }
    for (std::size_t i = 0; i < slots.size(); ++i) {
        const FrontSlot &from = slots[i];
        if (owned[i] == 0 || here[i] == kNoSlot) {
            continue;
        }
        if (!from.alive) {
            release(here[i]);
            continue;
        }
        FrontSlot &to = slots_[index(here[i])];
        to = from;
        to.next = here[index(from.next)];
        to.prev = here[index(from.prev)];
        to.node =
            index(from.node) < firstNew ? from.node : NodeId{static_cast<std::uint32_t>(index(from.node)) + shift};
        to.mark = {nextSerial_++, 0};
    }
    segments_ += part.front.segments_ - part.segments;
}

} // namespace forefront
