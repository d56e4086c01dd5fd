#pragma once

#include "core/front/generation_front.hpp"

#include <array>
#include <vector>

namespace forefront {

/// Bases by classes of length, two to the octave, first in first out within a class; segments that were deferred come
/// after all others. Cheaper than a strict order and as good for the mesh, since the advancer walks along the loop from
/// each base it takes. Entries of segments that are gone are skipped when they come up.
///
/// Unlike BaseOrder it has a history: what it delivers depends on the order of the offers. So it keeps a log, when
/// asked to, and goes back exactly.
class WalkOrder {
  public:
    /// Class of a length: floor(2·log2(length)), offset to be >= 0.
    static int level(double length);

    void offer(const GenerationFront &front, SlotId id);
    /// The next base, taken out; kNoSlot if there is none.
    SlotId take(const GenerationFront &front);
    bool empty() const { return lowest() == kBuckets; }
    /// Empties it; must have been called once before the first offer.
    void clear();

    /// From now on every change is logged (or no longer).
    void keepLog(bool keep) { logging_ = keep; }
    std::size_t logSize() const { return log_.size(); }
    /// Takes back all that was logged after the log had this size.
    void rollBack(std::size_t size);

    void addTo(Hash64 &hash) const;

  private:
    struct Entry {
        SlotId slot;
        std::uint32_t serial;
    };
    struct Bucket {
        std::vector<Entry> entries;
        std::size_t first = 0; ///< entries before it have been taken
    };
    struct Change {
        Entry entry;
        std::uint16_t bucket;
        bool offered;
    };
    static constexpr std::size_t kLevels = 4352; ///< all exponents of doubles, denormal ones included
    static constexpr std::size_t kBuckets = 2 * kLevels;

    std::size_t lowest() const;
    void mark(std::size_t bucket);
    void setFilled(std::size_t bucket, bool filled);

    Bucket &bucketAt(std::size_t bucket);

    std::vector<std::uint16_t> indices_; ///< per bucket: place in buckets_, from 1; 0: not used yet
    std::vector<Bucket> buckets_;
    std::array<std::uint64_t, kBuckets / 64> filled_{};           ///< bit per bucket that has entries left
    std::array<std::uint64_t, (kBuckets / 64 + 63) / 64> some_{}; ///< bit per word of `filled_` that is not 0
    std::vector<Change> log_;
    bool logging_ = false;
};

} // namespace forefront
