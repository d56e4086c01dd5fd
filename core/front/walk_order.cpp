#include "core/front/walk_order.hpp"

#include <bit>
#include <cstdint>
#include <limits>

namespace forefront {

int WalkOrder::level(double length) {
    constexpr int kOffset = 2160;
    constexpr int kBias = 1022; // of doubles whose mantissa is in [0.5, 1)
    constexpr std::uint64_t kMantissa = (std::uint64_t{1} << 52) - 1;
    constexpr std::uint64_t kHalfOctave = 0x6A09E667F3BCD; // mantissa of the root of 1/2
    if (length < std::numeric_limits<double>::min()) {     // denormal, or nothing at all
        constexpr int kShift = 64;
        return length > 0.0 ? level(length * 0x1p64) - 2 * kShift : kOffset;
    }
    const auto bits = std::bit_cast<std::uint64_t>(length);
    const int exponent = static_cast<int>(bits >> 52) - kBias;
    return 2 * exponent + ((bits & kMantissa) >= kHalfOctave ? 1 : 0) + kOffset;
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
    setFilled(bucket, b.first < b.entries.size());
}

void WalkOrder::setFilled(std::size_t bucket, bool filled) {
    const auto set = [](std::uint64_t &word, std::size_t bit, bool value) {
        word = (word & ~(std::uint64_t{1} << (bit % 64))) | (std::uint64_t{value} << (bit % 64));
    };
    const std::size_t word = bucket / 64;
    set(filled_[word], bucket, filled);
    set(some_[word / 64], word, filled_[word] != 0);
}

std::size_t WalkOrder::lowest() const {
    for (std::size_t group = 0; group < some_.size(); ++group) {
        if (some_[group] != 0) {
            const std::size_t word = group * 64 + static_cast<std::size_t>(std::countr_zero(some_[group]));
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
    setFilled(bucket, true);
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
    some_.fill(0);
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
