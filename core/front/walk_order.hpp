#pragma once

#include "core/front/generation_front.hpp"

#include <array>
#include <vector>

namespace forefront {

/// Bases by classes of length, 64 to the octave or two, first in first out within a class; segments that were deferred
/// come after all others. Cheaper than a strict order, and all that the mesh needs where the advancer walks along the
/// loop from each base it takes. Entries of segments that are gone are skipped when they come up.
///
/// Unlike BaseOrder it has a history: what it delivers depends on the order of the offers. So it keeps a log, when
/// asked to, and goes back exactly.
class WalkOrder {
  public:
    /// Class of a length: longer segments have the same or a greater one. 0 of length 0.
    std::uint32_t level(double length) const;

    void offer(const GenerationFront &front, SlotId id);
    /// The next base, taken out; kNoSlot if there is none.
    SlotId take(const GenerationFront &front);
    bool empty() const { return some_ == decltype(some_){}; }
    /// Empties it; must have been called once before the first offer. `fineClasses`: 64 to the octave; else two, the
    /// second from √2 on.
    void clear(bool fineClasses);

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
        std::uint32_t bucket;
        bool offered;
    };
    static constexpr std::uint32_t kClasses = 64;               ///< of an octave: as many as a word has bits
    static constexpr std::uint32_t kOctaves = 1024 + 1024 + 64; ///< of all positive doubles, denormal ones included
    static constexpr std::uint32_t kBuckets = 2 * kOctaves * kClasses;
    struct Octave {
        std::array<Bucket, kClasses> buckets;
    };

    std::uint32_t lowest() const;
    void mark(std::uint32_t bucket);
    void setFilled(std::uint32_t bucket, bool filled);
    Bucket &bucketAt(std::uint32_t bucket);

    std::vector<std::uint16_t> indices_; ///< per octave: place in octaves_, from 1; 0: not used yet
    std::vector<Octave> octaves_;
    std::array<std::uint64_t, 2 * kOctaves> filled_{};           ///< per octave: a bit per class with entries left
    std::array<std::uint64_t, (2 * kOctaves + 63) / 64> some_{}; ///< bit per octave with any
    std::vector<Change> log_;
    bool fine_ = false;
    bool logging_ = false;
};

} // namespace forefront
