#include "core/engine/quads/front_layers.hpp"

#include <cmath>

namespace forefront {

namespace {

constexpr double kClassesPerOctave = 2.0;
/// Moves the borders of the classes away from powers of two, which are common sizes.
constexpr double kClassShift = 0.37;

} // namespace

void FrontLayers::setLayer(SlotId id, std::uint32_t layer) {
    if (layers_.size() <= index(id)) {
        layers_.resize(2 * index(id) + 16, 0);
    }
    layers_[index(id)] = layer;
}

void FrontLayers::offerLeg(const GenerationFront &front, SlotId id, std::uint32_t layer) {
    setLayer(id, layer);
    const double rho = 0.5 * (front[id].rho + front[front.next(id)].rho);
    const int spacingClass = static_cast<int>(std::floor(kClassesPerOctave * std::log2(rho) + kClassShift));
    if (!lattice_ && layer >= rows_) {
        waiting_[{spacingClass, 0}].entries.push_back(entry(front, id));
    } else {
        legs_[{spacingClass, layer}].entries.push_back(entry(front, id));
    }
}

SlotId FrontLayers::takeFrom(std::map<Key, Queue> &queues, const GenerationFront &front) {
    while (!queues.empty()) {
        Queue &queue = queues.begin()->second;
        while (queue.head < queue.entries.size()) {
            const Entry e = queue.entries[queue.head++];
            if (isCurrent(front, e)) {
                return e.id;
            }
        }
        queues.erase(queues.begin());
    }
    return kNoSlot;
}

SlotId FrontLayers::takeNewest(std::vector<Entry> &entries, const GenerationFront &front) {
    while (!entries.empty()) {
        const Entry e = entries.back();
        entries.pop_back();
        if (isCurrent(front, e)) {
            return e.id;
        }
    }
    return kNoSlot;
}

SlotId FrontLayers::take(const GenerationFront &front) {
    SlotId id = takeNewest(diagonals_, front);
    if (id == kNoSlot) {
        id = takeNewest(late_, front);
    }
    if (id == kNoSlot) {
        id = takeFrom(legs_, front);
    }
    if (id == kNoSlot) { // one leg of those that wait; its descendants come before the others
        lattice_ = true;
        id = takeFrom(waiting_, front);
    }
    return id;
}

} // namespace forefront
