#pragma once

#include "core/engine/base/assert.hpp"
#include "core/engine/base/hash.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/base/vec2.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

struct DiscreteDomain;
struct FrontPart;

/// The data of a front segment that the base order uses.
struct SegmentMark {
    std::uint32_t serial = 0;       ///< ordinal of its creation, unique within a run
    std::uint32_t failureClass = 0; ///< how often it was deferred as base
};

/// A front node together with its outgoing front segment. A node where the front touches itself has one slot for each
/// free angle, so that every angle test is local to its slot. An isolated constraint point is a slot that is its own
/// neighbour.
struct alignas(64) FrontSlot {
    Vec2 position;       ///< of the node, in domain units
    double length = 0.0; ///< of the outgoing segment
    double rho = 0.0;    ///< node spacing at the node; fast method only
    NodeId node = kNoNode;
    SlotId next = kNoSlot;  ///< where the outgoing segment ends
    SlotId prev = kNoSlot;  ///< where the incoming segment starts
    SegmentMark mark;       ///< of the outgoing segment
    std::uint32_t face = 0; ///< index of the face it borders, on its left
    bool alive = false;
};

/// The generation front Γ: closed loops of directed segments with the unmeshed area on their left. It has only links
/// and lengths, not the nodes or the cells that a segment crosses. All changes can be undone in reverse order,
/// including slot ids and serials.
class GenerationFront {
  public:
    /// An empty front.
    GenerationFront() = default;
    /// Γ := B. Every side of a discrete segment that faces the domain becomes a front segment.
    explicit GenerationFront(const DiscreteDomain &boundary);

    const FrontSlot &operator[](SlotId id) const { return slots_[index(id)]; }
    SlotId next(SlotId id) const { return slots_[index(id)].next; }
    SlotId prev(SlotId id) const { return slots_[index(id)].prev; }
    Vec2 start(SlotId id) const { return slots_[index(id)].position; }
    Vec2 end(SlotId id) const { return start(next(id)); }
    bool isolated(SlotId id) const { return slots_[index(id)].next == id; }

    /// Returns Nb, the number of segments of Γ.
    std::size_t segments() const { return segments_; }
    bool empty() const { return segments_ == 0; }
    /// Returns the number of slots. Ids run from 0 to capacity() - 1, including dead ones.
    std::size_t capacity() const { return slots_.size(); }
    /// Returns the number of slots in use: one for each segment and each isolated point.
    std::size_t slots() const { return slots_.size() - free_.size(); }
    /// Calls visit(id) for each slot in use, by id.
    template <class Visit>
    void forEachSlot(Visit visit) const {
        for (std::uint32_t i = 0; i < slots_.size(); ++i) {
            if (slots_[i].alive) {
                visit(SlotId{i});
            }
        }
    }
    std::uint32_t nextSerial() const { return nextSerial_; }
    /// Returns the memory in use, in bytes.
    std::size_t bytes() const { return slots_.capacity() * sizeof(FrontSlot) + free_.capacity() * sizeof(SlotId); }

    /// Changes A→B to A→C→B with a new node C and returns the slot of C.
    SlotId insertAfter(SlotId a, Vec2 position, NodeId node);
    void undoInsertAfter(SlotId a, SlotId c, SegmentMark base);

    /// Removes slot x from its loop: P→X→N becomes the new segment P→N.
    void cutOut(SlotId x);
    /// Undoes cutOut(). `node`, `position`, `mark`: of slot x, which was after p; `markOfP`: of P→X.
    void undoCutOut(SlotId x, SlotId p, NodeId node, Vec2 position, SegmentMark mark, SegmentMark markOfP);

    /// Gives slot x a new node C: P→X→N becomes P→C→N.
    void replace(SlotId x, Vec2 position, NodeId node);
    /// Undoes replace(). `mark` and `markOfPrev`: of X→N and P→X.
    void undoReplace(SlotId x, NodeId node, Vec2 position, SegmentMark mark, SegmentMark markOfPrev);

    /// Removes the loop of three slots that starts at a.
    void removeLoop(SlotId a);
    struct LoopSlot {
        SlotId id;
        NodeId node;
        Vec2 position;
        SegmentMark mark;
    };
    void undoRemoveLoop(const LoopSlot (&loop)[3], std::uint32_t face);

    /// Changes A→B to A→C and C→B, where C is the node of slot s elsewhere on Γ. One loop becomes two, or two become
    /// one. s keeps its outgoing segment and follows A; the returned new slot of the same node takes the incoming one
    /// and leads to B. Returns s itself if s is isolated.
    SlotId connect(SlotId a, SlotId s);
    void undoConnect(SlotId a, SlotId s, SlotId t, SegmentMark base);

    void setRho(SlotId id, double rho) { slots_[index(id)].rho = rho; }
    void setFailureClass(SlotId id, std::uint32_t failureClass) { slots_[index(id)].mark.failureClass = failureClass; }

    /// Returns the part of Γ that consists of the segments and isolated points of these slots, which are distinct and
    /// alive.
    FrontPart part(std::span<const SlotId> slots) const;
    /// Copies back a part that changed only inside `box`. Ids of its nodes from `firstNew` on are increased by `shift`.
    void adopt(const FrontPart &part, const Box2 &box, std::uint32_t firstNew, std::uint32_t shift);

    /// Returns true if the direction from the node of s to p lies strictly inside the free angle of s (exact).
    bool insideAngle(SlotId s, Vec2 p) const;

    /// Returns true if links are mutual and lengths and counts correct; for tests and assertions.
    bool consistent() const;
    void addTo(Hash64 &hash) const;

  private:
    SlotId allocate();
    void release(SlotId id);
    SlotId revive(SlotId expected, NodeId node, Vec2 position, std::uint32_t face, SegmentMark mark);
    void link(SlotId from, SlotId to);
    void renew(SlotId id);                     ///< gives the outgoing segment a new mark
    void restore(SlotId id, SegmentMark mark); ///< gives the outgoing segment an earlier mark

    std::vector<FrontSlot> slots_;
    std::vector<SlotId> free_;
    std::size_t segments_ = 0;
    std::uint32_t nextSerial_ = 0;
};

/// Some segments and isolated points of Γ, with the slots of their ends. Links that leave the part are kNoSlot.
struct FrontPart {
    GenerationFront front;
    std::vector<SlotId> origin; ///< per copied slot: its original, ascending
    std::size_t segments = 0;   ///< number of copied segments
};

} // namespace forefront
