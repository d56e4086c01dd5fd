#pragma once

#include "core/engine/front/generation_front.hpp"

#include <array>
#include <vector>

namespace forefront {

/// The rules by which a WalkOrder sorts segments.
struct WalkRules {
    bool fineClasses = false;        ///< 64 classes per octave; else two, the second from √2 on
    std::uint32_t boundaryNodes = 0; ///< number of boundary nodes, which are the first; 0: no preference
};

/// Orders bases by length class, 64 or two per octave, first in first out within a class. Segments between
/// two boundary nodes count as half as long, so that the front usually leaves the whole boundary before it returns to
/// it. Deferred segments come after all others. This is cheaper than a strict order and sufficient where the advancer
/// walks along the loop from each base. Entries of segments that are gone are skipped.
///
/// Unlike BaseOrder, the result depends on the order of the offers, so a log of all changes can be kept and rolled back
/// exactly.
class WalkOrder {
  public:
    /// Returns the class of a length, which never falls as the length grows; 0 for length 0.
    std::uint32_t level(double length) const;
    /// Returns the class of a segment.
    std::uint32_t levelOf(const GenerationFront &front, SlotId id) const;

    /// Adds a segment.
    void offer(const GenerationFront &front, SlotId id);
    /// Removes and returns the next base; kNoSlot if there is none.
    SlotId take(const GenerationFront &front);
    bool empty() const { return some_ == decltype(some_){}; }
    /// Removes all entries; must be called once before the first offer.
    void clear(const WalkRules &rules);

    /// Starts or stops logging every change.
    void keepLog(bool keep) { logging_ = keep; }
    std::size_t logSize() const { return dropped_ + log_.size(); }
    /// Undoes all changes logged since the log had this size, which must not lie in a dropped part.
    void rollBack(std::size_t size);
    /// Returns a copy without the log and without entries that are taken. Its logSize() stays the same.
    WalkOrder withoutHistory() const;
    /// Returns the memory in use, in bytes.
    std::size_t bytes() const;

    void addTo(Hash64 &hash) const;

  private:
    struct Entry {
        SlotId slot;
        std::uint32_t serial;
    };
    struct Bucket {
        std::vector<Entry> entries;
        std::size_t first = 0; ///< entries before it are taken
    };
    struct Change {
        Entry entry;
        std::uint32_t bucket;
        bool offered;
    };
    static constexpr std::uint32_t kClasses = 64;               ///< per octave: as many as a word has bits
    static constexpr std::uint32_t kOctaves = 1024 + 1024 + 64; ///< of all positive doubles, including denormal ones
    static constexpr std::uint32_t kBuckets = 2 * kOctaves * kClasses;
    struct Octave {
        std::array<Bucket, kClasses> buckets;
    };

    std::uint32_t lowest() const;
    void mark(std::uint32_t bucket);
    void setFilled(std::uint32_t bucket, bool filled);
    Bucket &bucketAt(std::uint32_t bucket);

    std::vector<std::uint16_t> indices_; ///< per octave: position in octaves_ from 1 on; 0: unused
    std::vector<Octave> octaves_;
    std::array<std::uint64_t, 2 * kOctaves> filled_{};           ///< per octave: a bit per class with entries left
    std::array<std::uint64_t, (2 * kOctaves + 63) / 64> some_{}; ///< bit per octave with any
    std::vector<Change> log_;
    std::size_t dropped_ = 0; ///< number of changes before the first one in log_
    WalkRules rules_;
    bool logging_ = false;
};

} // namespace forefront
