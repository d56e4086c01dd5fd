#include "core/engine/front/walk_order.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

namespace forefront {

std::uint32_t WalkOrder::level(double length) const {
    if (length < std::numeric_limits<double>::min()) { // denormal, or 0
        return length > 0.0 ? level(length * 0x1p64) - 64 * kClasses : 0;
    }
    constexpr int kMantissaBits = 52;
    constexpr int kClassBits = std::countr_zero(kClasses);
    const auto bits = std::bit_cast<std::uint64_t>(length);
    const auto octave = static_cast<std::uint32_t>(bits >> kMantissaBits) + 64;
    if (rules_.fineClasses) { // the first bits of the mantissa
        return octave * kClasses + (static_cast<std::uint32_t>(bits >> (kMantissaBits - kClassBits)) % kClasses);
    }
    constexpr std::uint64_t kMantissa = (std::uint64_t{1} << kMantissaBits) - 1;
    constexpr std::uint64_t kRootOfTwo = 0x6A09E667F3BCD; // its mantissa
    return octave * kClasses + ((bits & kMantissa) >= kRootOfTwo ? kClasses / 2 : 0);
}

std::uint32_t WalkOrder::levelOf(const GenerationFront &front, SlotId id) const {
    const FrontSlot &slot = front[id];
    const std::uint32_t own = level(slot.length);
    const bool ofBoundary = std::max(index(slot.node), index(front[slot.next].node)) < rules_.boundaryNodes;
    return ofBoundary ? own - std::min(own, kClasses) : own;
}

WalkOrder::Bucket &WalkOrder::bucketAt(std::uint32_t bucket) {
    std::uint16_t &place = indices_[bucket / kClasses];
    if (place == 0) {
        octaves_.emplace_back();
        place = static_cast<std::uint16_t>(octaves_.size());
    }
    return octaves_[place - 1U].buckets[bucket % kClasses];
}

void WalkOrder::mark(std::uint32_t bucket) {
    const Bucket &b = bucketAt(bucket);
    setFilled(bucket, b.first < b.entries.size());
}

void WalkOrder::setFilled(std::uint32_t bucket, bool filled) {
    const auto set = [](std::uint64_t &word, std::uint32_t bit, bool value) {
        word = (word & ~(std::uint64_t{1} << (bit % 64))) | (std::uint64_t{value} << (bit % 64));
    };
    const std::uint32_t octave = bucket / kClasses;
    set(filled_[octave], bucket, filled);
    set(some_[octave / 64], octave, filled_[octave] != 0);
}

std::uint32_t WalkOrder::lowest() const {
    for (std::uint32_t group = 0; group < some_.size(); ++group) {
        if (some_[group] != 0) {
            const std::uint32_t octave = group * 64 + static_cast<std::uint32_t>(std::countr_zero(some_[group]));
            return octave * kClasses + static_cast<std::uint32_t>(std::countr_zero(filled_[octave]));
        }
    }
    return kBuckets;
}

void WalkOrder::offer(const GenerationFront &front, SlotId id) {
    const FrontSlot &slot = front[id];
    const std::uint32_t bucket = levelOf(front, id) + (slot.mark.failureClass > 0 ? kOctaves * kClasses : 0);
    const Entry entry{id, slot.mark.serial};
    bucketAt(bucket).entries.push_back(entry);
    setFilled(bucket, true);
    if (logging_) {
        log_.push_back({entry, bucket, true});
    }
}

SlotId WalkOrder::take(const GenerationFront &front) {
    constexpr std::size_t kCompactFrom = 1024;
    for (std::uint32_t bucket = lowest(); bucket < kBuckets; bucket = lowest()) {
        Bucket &b = bucketAt(bucket);
        SlotId found = kNoSlot;
        while (b.first < b.entries.size() && found == kNoSlot) {
            const Entry entry = b.entries[b.first++];
            const FrontSlot &slot = front[entry.slot];
            const bool classOk = (slot.mark.failureClass > 0) == (bucket >= kOctaves * kClasses);
            found = slot.alive && slot.mark.serial == entry.serial && classOk ? entry.slot : kNoSlot;
            if (logging_) {
                log_.push_back({entry, bucket, false});
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

void WalkOrder::clear(const WalkRules &rules) {
    rules_ = rules;
    indices_.resize(2 * kOctaves, 0);
    for (std::uint32_t bucket = lowest(); bucket < kBuckets; bucket = lowest()) {
        Bucket &b = bucketAt(bucket);
        b.entries.resize(b.first);
        setFilled(bucket, false);
    }
}

void WalkOrder::rollBack(std::size_t size) {
    for (; logSize() > size; log_.pop_back()) {
        const Change &change = log_.back();
        Bucket &b = bucketAt(change.bucket);
        if (change.offered) {
            b.entries.pop_back();
        } else if (b.first > 0) {
            b.entries[--b.first] = change.entry;
        } else { // the log began after earlier entries had been dropped
            b.entries.insert(b.entries.begin(), change.entry);
        }
        mark(change.bucket);
    }
}

WalkOrder WalkOrder::withoutHistory() const {
    WalkOrder copy;
    copy.indices_ = indices_;
    copy.octaves_.resize(octaves_.size());
    for (std::size_t i = 0; i < octaves_.size(); ++i) {
        for (std::size_t k = 0; k < kClasses; ++k) {
            const Bucket &b = octaves_[i].buckets[k];
            copy.octaves_[i].buckets[k].entries.assign(b.entries.begin() + static_cast<std::ptrdiff_t>(b.first),
                                                       b.entries.end());
        }
    }
    copy.filled_ = filled_;
    copy.some_ = some_;
    copy.dropped_ = logSize();
    copy.rules_ = rules_;
    copy.logging_ = logging_;
    return copy;
}

std::size_t WalkOrder::bytes() const {
    std::size_t sum = sizeof *this + indices_.capacity() * sizeof indices_[0] + log_.capacity() * sizeof(Change);
    for (const Octave &octave : octaves_) {
        sum += sizeof octave;
        for (const Bucket &b : octave.buckets) {
            sum += b.entries.capacity() * sizeof(Entry);
        }
    }
    return sum;
}

void WalkOrder::addTo(Hash64 &hash) const {
    for (std::uint32_t octave = 0; octave < filled_.size(); ++octave) {
        for (std::uint64_t bits = filled_[octave]; bits != 0; bits &= bits - 1) {
            const auto place = static_cast<std::size_t>(std::countr_zero(bits));
            const Bucket &b = octaves_[indices_[octave] - 1U].buckets[place];
            for (std::size_t i = b.first; i < b.entries.size(); ++i) {
                hash.add((static_cast<std::uint64_t>(index(b.entries[i].slot)) << 32) | b.entries[i].serial);
            }
        }
    }
}

} // namespace forefront
