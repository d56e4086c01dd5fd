#include "core/engine/quads/front_layers.hpp"

#include <cmath>
#include <utility>

namespace forefront {

namespace {

constexpr double kClassesPerOctave = 2.0;
/// Moves the borders of the classes away from powers of two, which are common sizes.
constexpr double kClassShift = 0.37;

} // namespace

void FrontLayers::push(std::vector<Entry> &entries, Op op, const GenerationFront &front, SlotId id) {
    entries.push_back(entry(front, id));
    log({.op = op});
}

void FrontLayers::setLayer(SlotId id, std::uint32_t layer) {
    if (layers_.size() <= index(id)) {
        layers_.resize(2 * index(id) + 16, 0);
    }
    log(Change::ofEntry(Op::Layer, {id, 0}, layers_[index(id)]));
    layers_[index(id)] = layer;
}

void FrontLayers::offerLeg(const GenerationFront &front, SlotId id, std::uint32_t layer) {
    setLayer(id, layer);
    const double rho = 0.5 * (front[id].rho + front[front.next(id)].rho);
    const int spacingClass = static_cast<int>(std::floor(kClassesPerOctave * std::log2(rho) + kClassShift));
    const bool waits = !lattice_ && layer >= rows_;
    const Key key{spacingClass, waits ? 0 : layer};
    (waits ? waiting_ : legs_)[key].entries.push_back(entry(front, id));
    log(Change::ofKey(waits ? Op::OfferWait : Op::OfferLeg, key));
}

SlotId FrontLayers::takeFrom(Queues &queues, Op taken, Op ended, const GenerationFront &front) {
    while (!queues.empty()) {
        const Key key = queues.begin()->first;
        Queue &queue = queues.begin()->second;
        const std::size_t before = queue.head;
        SlotId found = kNoSlot;
        while (queue.head < queue.entries.size() && found == kNoSlot) {
            const Entry e = queue.entries[queue.head++];
            found = isCurrent(front, e) ? e.id : kNoSlot;
        }
        log(Change::ofKey(taken, key, queue.head - before));
        if (found != kNoSlot) {
            return found;
        }
        if (logging_) {
            ended_.push_back(std::move(queue));
            log(Change::ofKey(ended, key));
        }
        queues.erase(queues.begin());
    }
    return kNoSlot;
}

SlotId FrontLayers::takeNewest(std::vector<Entry> &entries, Op op, const GenerationFront &front) {
    while (!entries.empty()) {
        const Entry e = entries.back();
        entries.pop_back();
        log(Change::ofEntry(op, e));
        if (isCurrent(front, e)) {
            return e.id;
        }
    }
    return kNoSlot;
}

SlotId FrontLayers::take(const GenerationFront &front) {
    SlotId id = takeNewest(diagonals_, Op::TakeDiagonal, front);
    if (id == kNoSlot) {
        id = takeNewest(late_, Op::TakeLate, front);
    }
    if (id == kNoSlot) {
        id = takeFrom(legs_, Op::TakeLeg, Op::EndLegs, front);
    }
    if (id == kNoSlot) { // one leg of those that wait; its descendants come before the others
        if (!lattice_) {
            log({.op = Op::Lattice});
        }
        lattice_ = true;
        id = takeFrom(waiting_, Op::TakeWait, Op::EndWait, front);
    }
    return id;
}

void FrontLayers::undo(const Change &change) {
    const auto undoOffer = [&](Queues &queues) {
        const auto found = queues.find(change.key());
        found->second.entries.pop_back();
        if (found->second.entries.empty()) { // that offer made the queue
            queues.erase(found);
        }
    };
    const auto undoEnd = [&](Queues &queues) {
        queues.emplace(change.key(), std::move(ended_.back()));
        ended_.pop_back();
    };
    switch (change.op) {
    case Op::OfferDiagonal:
        diagonals_.pop_back();
        break;
    case Op::DeferDiagonal:
        late_.pop_back();
        break;
    case Op::TakeDiagonal:
        diagonals_.push_back(change.entry());
        break;
    case Op::TakeLate:
        late_.push_back(change.entry());
        break;
    case Op::OfferLeg:
        undoOffer(legs_);
        break;
    case Op::OfferWait:
        undoOffer(waiting_);
        break;
    case Op::TakeLeg:
        legs_.find(change.key())->second.head -= change.count;
        break;
    case Op::TakeWait:
        waiting_.find(change.key())->second.head -= change.count;
        break;
    case Op::EndLegs:
        undoEnd(legs_);
        break;
    case Op::EndWait:
        undoEnd(waiting_);
        break;
    case Op::Lattice:
        lattice_ = false;
        break;
    case Op::Layer:
        layers_[change.first] = change.count;
        break;
    }
}

void FrontLayers::rollBack(std::size_t size) {
    while (log_.size() > size) {
        const Change change = log_.back();
        log_.pop_back();
        undo(change);
    }
}

FrontLayers FrontLayers::withoutHistory() const {
    FrontLayers copy(rows_);
    copy.lattice_ = lattice_;
    copy.diagonals_ = diagonals_;
    copy.late_ = late_;
    copy.layers_ = layers_;
    const auto left = [](const Queues &from, Queues &to) {
        for (const auto &[key, queue] : from) {
            if (queue.head < queue.entries.size()) {
                const auto head = queue.entries.begin() + static_cast<std::ptrdiff_t>(queue.head);
                to.emplace(key, Queue{{head, queue.entries.end()}, 0});
            }
        }
    };
    left(legs_, copy.legs_);
    left(waiting_, copy.waiting_);
    return copy;
}

std::size_t FrontLayers::bytes() const {
    std::size_t entries = diagonals_.capacity() + late_.capacity();
    for (const Queues *queues : {&legs_, &waiting_}) {
        for (const auto &[key, queue] : *queues) {
            entries += queue.entries.capacity() + sizeof(Queue) / sizeof(Entry);
        }
    }
    return sizeof *this + entries * sizeof(Entry) + layers_.capacity() * sizeof(std::uint32_t) +
           log_.capacity() * sizeof(Change);
}

void FrontLayers::addTo(Hash64 &hash) const {
    const auto add = [&](const Entry &e) {
        hash.add((static_cast<std::uint64_t>(index(e.id)) << 32U) | e.serial);
        hash.add(std::uint64_t{layerOf(e.id)});
    };
    for (const std::vector<Entry> *entries : {&diagonals_, &late_}) {
        hash.add(static_cast<std::uint64_t>(entries->size()));
        for (const Entry &e : *entries) {
            add(e);
        }
    }
    for (const Queues *queues : {&legs_, &waiting_}) {
        for (const auto &[key, queue] : *queues) {
            for (std::size_t i = queue.head; i < queue.entries.size(); ++i) {
                hash.add((static_cast<std::uint64_t>(static_cast<std::uint32_t>(key.spacingClass)) << 32U) | key.layer);
                add(queue.entries[i]);
            }
        }
    }
    hash.add(std::uint64_t{lattice_ ? 1U : 0U});
}

} // namespace forefront
