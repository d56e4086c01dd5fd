#include "core/front/generation_front.hpp"

namespace forefront {

FrontPart GenerationFront::part(const Box2 &box) const {
    FrontPart part;
    std::vector<std::uint8_t> taken(slots_.size(), 0);
    for (std::uint32_t i = 0; i < slots_.size(); ++i) {
        const SlotId id{i};
        if (slots_[i].alive && box.overlaps(boxOf(start(id), end(id)))) {
            taken[i] = taken[index(next(id))] = 1;
            part.segments += isolated(id) ? 0U : 1U;
        }
    }
    std::vector<SlotId> inPart(slots_.size(), kNoSlot);
    std::vector<SlotId> &origin = part.origin;
    for (std::uint32_t i = 0; i < slots_.size(); ++i) {
        if (taken[i] != 0) {
            inPart[i] = SlotId{static_cast<std::uint32_t>(origin.size())};
            origin.push_back(SlotId{i});
        }
    }
    part.front.slots_.reserve(origin.size() + origin.size() / 2);
    for (const SlotId id : origin) {
        FrontSlot slot = slots_[index(id)];
        slot.next = inPart[index(slot.next)];
        slot.prev = inPart[index(slot.prev)];
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
        owned[i] = holds(box, start(origin[i])) ? 1 : 0;
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
