#include "core/front/walk_order.hpp"

#include <bit>
#include <cmath>

namespace forefront {

int WalkOrder::level(double length) {
    constexpr int kOffset = 2160;
    constexpr double kHalfOctave = 0.7071067811865476;
    int exponent = 0;
    const double mantissa = std::frexp(length, &exponent); // in [0.5, 1)
    return 2 * exponent + (mantissa >= kHalfOctave ? 1 : 0) + kOffset;
}

WalkOrder::Bucket &WalkOrder::bucketAt(std::size_t bucket) {
    if (indices_[bucket] == 0) {
        buckets_.emplace_back();
        indices_[bucket] = static_cast<std::uint16_t>(buckets_.size());
    }
    return buckets_[indices_[bucket] - 1U];
}

void WalkOrder::mark(std::size_t bucket) {
    const Bucket &b = bucketAt(bucket);
    const std::uint64_t bit = std::uint64_t{1} << (bucket % 64);
    if (b.first < b.entries.size()) {
        filled_[bucket / 64] |= bit;
    } else {
        filled_[bucket / 64] &= ~bit;
    }
}

std::size_t WalkOrder::lowest() const {
    for (std::size_t word = 0; word < filled_.size(); ++word) {
        if (filled_[word] != 0) {
            return word * 64 + static_cast<std::size_t>(std::countr_zero(filled_[word]));
        }
    }
    return kBuckets;
}

void WalkOrder::offer(const GenerationFront &front, SlotId id) {
    const FrontSlot &slot = front[id];
    const std::size_t bucket =
        static_cast<std::size_t>(level(slot.length)) + (slot.mark.failureClass > 0 ? kLevels : 0);
    const Entry entry{id, slot.mark.serial};
    bucketAt(bucket).entries.push_back(entry);
    filled_[bucket / 64] |= std::uint64_t{1} << (bucket % 64);
    if (logging_) {
        log_.push_back({entry, static_cast<std::uint16_t>(bucket), true});
    }
}

SlotId WalkOrder::take(const GenerationFront &front) {
    constexpr std::size_t kCompactFrom = 1024;
    for (std::size_t bucket = lowest(); bucket < kBuckets; bucket = lowest()) {
        Bucket &b = bucketAt(bucket);
        SlotId found = kNoSlot;
        while (b.first < b.entries.size() && found == kNoSlot) {
            const Entry entry = b.entries[b.first++];
            const FrontSlot &slot = front[entry.slot];
            const bool classOk = (slot.mark.failureClass > 0) == (bucket >= kLevels);
            found = slot.alive && slot.mark.serial == entry.serial && classOk ? entry.slot : kNoSlot;
            if (logging_) {
                log_.push_back({entry, static_cast<std::uint16_t>(bucket), false});
            }
        }
        if (!logging_ && (b.first == b.entries.size() || (b.first > kCompactFrom && 2 * b.first > b.entries.size()))) {
            b.entries.erase(b.entries.begin(), b.entries.begin() + static_cast<std::ptrdiff_t>(b.first));
            b.first = 0;
        }
        mark(bucket);
        if (found != kNoSlot) {
            return found;
        }
    }
    return kNoSlot;
}

void WalkOrder::clear() {
    indices_.resize(kBuckets, 0);
    for (std::size_t word = 0; word < filled_.size(); ++word) {
        for (; filled_[word] != 0; filled_[word] &= filled_[word] - 1) {
            Bucket &b = bucketAt(word * 64 + static_cast<std::size_t>(std::countr_zero(filled_[word])));
            b.entries.resize(b.first);
        }
    }
}

void WalkOrder::rollBack(std::size_t size) {
    for (; log_.size() > size; log_.pop_back()) {
        const Change &change = log_.back();
        Bucket &b = bucketAt(change.bucket);
        if (change.offered) {
            b.entries.pop_back();
        } else if (b.first > 0) {
            b.entries[--b.first] = change.entry;
        } else { // the log was begun after what came before had been forgotten
            b.entries.insert(b.entries.begin(), change.entry);
        }
        mark(change.bucket);
    }
}

void WalkOrder::addTo(Hash64 &hash) const {
    for (std::size_t word = 0; word < filled_.size(); ++word) {
        for (std::uint64_t bits = filled_[word]; bits != 0; bits &= bits - 1) {
            const std::size_t bucket = word * 64 + static_cast<std::size_t>(std::countr_zero(bits));
            const Bucket &b = buckets_[indices_[bucket] - 1U];
            for (std::size_t i = b.first; i < b.entries.size(); ++i) {
                hash.add((static_cast<std::uint64_t>(index(b.entries[i].slot)) << 32) | b.entries[i].serial);
            }
        }
    }
}

} // namespace forefront
