#pragma once

#include "core/engine/base/hash.hpp"
#include "core/engine/front/generation_front.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace forefront {

/// The order of the bases of the two-coloured front: diagonals first, the newest one first, since their second halves
/// complete squares; then legs by class of node spacing, smallest first, and within a class row by row, in the order
/// in which they were made.
///
/// Rows from the boundary meet in the middle of the domain. If there is a limit on their number, deeper legs wait until
/// no others are left. Then one of them starts a lattice that grows through the rest of the domain.
///
/// A log of all changes can be kept and rolled back exactly.
class FrontLayers {
  public:
    static constexpr std::uint32_t kAllRows = std::numeric_limits<std::uint32_t>::max();

    /// `rows`: number of rows along the boundary before the lattice grows.
    explicit FrontLayers(std::uint32_t rows = kAllRows) : rows_(rows) {}

    void offerDiagonal(const GenerationFront &front, SlotId id) { push(diagonals_, Op::OfferDiagonal, front, id); }
    /// Offers a diagonal that no apex was found for, behind all others.
    void deferDiagonal(const GenerationFront &front, SlotId id) { push(late_, Op::DeferDiagonal, front, id); }
    void offerLeg(const GenerationFront &front, SlotId id, std::uint32_t layer);
    /// Returns the next base and removes it; kNoSlot: there is none.
    SlotId take(const GenerationFront &front);
    /// Returns the row that a segment was offered for.
    std::uint32_t layerOf(SlotId id) const { return index(id) < layers_.size() ? layers_[index(id)] : 0; }
    void setLayer(SlotId id, std::uint32_t layer);

    /// Starts or stops logging every change.
    void keepLog(bool keep) { logging_ = keep; }
    std::size_t logSize() const { return log_.size(); }
    /// Undoes all changes logged since the log had this size.
    void rollBack(std::size_t size);
    /// Returns a copy without the log and without entries that are taken.
    FrontLayers withoutHistory() const;
    /// Returns about the memory in use, in bytes.
    std::size_t bytes() const;
    void addTo(Hash64 &hash) const;

  private:
    struct Entry {
        SlotId id;
        std::uint32_t serial;
    };
    /// First in, first out.
    struct Queue {
        std::vector<Entry> entries;
        std::size_t head = 0;
    };
    struct Key {
        int spacingClass;
        std::uint32_t layer;
        friend auto operator<=>(const Key &, const Key &) = default;
    };
    using Queues = std::map<Key, Queue>;

    enum class Op : std::uint8_t {
        OfferDiagonal,
        DeferDiagonal,
        TakeDiagonal, ///< `entry` was taken from the diagonals
        TakeLate,
        OfferLeg,  ///< to the queue `key`
        OfferWait, ///< to the queue `key` of those that wait
        TakeLeg,   ///< `count` entries of the queue `key`
        TakeWait,
        EndLegs, ///< the queue `key` was used up and is the last one of `ended_`
        EndWait,
        Lattice, ///< it began to grow
        Layer    ///< of the slot `entry.id`, which was `count`
    };
    struct Change {
        Op op;
        std::uint32_t count = 0;
        std::uint32_t first = 0, second = 0; ///< of an entry: slot and serial; of a key: class and layer

        static Change ofEntry(Op op, const Entry &e, std::uint32_t count = 0) {
            return {op, count, static_cast<std::uint32_t>(index(e.id)), e.serial};
        }
        static Change ofKey(Op op, const Key &k, std::size_t count = 0) {
            return {op, static_cast<std::uint32_t>(count), static_cast<std::uint32_t>(k.spacingClass), k.layer};
        }
        Entry entry() const { return {SlotId{first}, second}; }
        Key key() const { return {static_cast<int>(first), second}; }
    };

    static Entry entry(const GenerationFront &front, SlotId id) { return {id, front[id].mark.serial}; }
    static bool isCurrent(const GenerationFront &front, const Entry &e) {
        return front[e.id].alive && front[e.id].mark.serial == e.serial;
    }
    void push(std::vector<Entry> &entries, Op op, const GenerationFront &front, SlotId id);
    SlotId takeFrom(Queues &queues, Op taken, Op ended, const GenerationFront &front);
    SlotId takeNewest(std::vector<Entry> &entries, Op op, const GenerationFront &front);
    void log(const Change &change) {
        if (logging_) {
            log_.push_back(change);
        }
    }
    void undo(const Change &change);

    std::uint32_t rows_;
    bool lattice_ = false; ///< it has started to grow
    bool logging_ = false;
    std::vector<Entry> diagonals_, late_;
    Queues legs_, waiting_;
    std::vector<std::uint32_t> layers_; ///< per slot
    std::vector<Change> log_;
    std::vector<Queue> ended_; ///< queues that the log has used up
};

} // namespace forefront
