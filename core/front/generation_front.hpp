#pragma once

#include "core/base/assert.hpp"
#include "core/base/hash.hpp"
#include "core/base/ids.hpp"
#include "core/base/vec2.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

struct DiscreteDomain;
struct FrontPart;

/// What the base order knows of a segment of Γ.
struct SegmentMark {
    std::uint32_t serial = 0;       ///< number of its creation, unique within a run
    std::uint32_t failureClass = 0; ///< how often it was deferred as base
};

/// A front node together with its outgoing front segment. A node where the front touches itself has one slot for each
/// free angle, so that every angle test is local to its slot. An isolated constraint point is a slot that is its own
/// neighbour.
struct alignas(64) FrontSlot {
    Vec2 position;       ///< of the node, in domain units
    double length = 0.0; ///< of the outgoing segment
    double rho = 0.0;    ///< node spacing at the node, where the method keeps it
    NodeId node = kNoNode;
    SlotId next = kNoSlot;    ///< where the outgoing segment ends
    SlotId prev = kNoSlot;    ///< where the incoming segment starts
    SegmentMark mark;         ///< of the outgoing segment
    std::uint32_t face = 0; ///< index of the face it borders, on its left
    bool alive = false;
};

/// Γ: closed loops of directed segments with the unmeshed region on their left. Only links and lengths live here; which
/// nodes exist and which cells a segment crosses is kept by others. All changes are reversible, in reverse order,
/// including slot ids and serials.
class GenerationFront {
  public:
    /// Γ = ∅.
    GenerationFront() = default;
    /// Γ := B. Every side of a discrete segment that borders the domain becomes a front segment.
    explicit GenerationFront(const DiscreteDomain &boundary);

    const FrontSlot &operator[](SlotId id) const { return slots_[index(id)]; }
    SlotId next(SlotId id) const { return slots_[index(id)].next; }
    SlotId prev(SlotId id) const { return slots_[index(id)].prev; }
    Vec2 start(SlotId id) const { return slots_[index(id)].position; }
    Vec2 end(SlotId id) const { return start(next(id)); }
    bool isolated(SlotId id) const { return slots_[index(id)].next == id; }

    /// Number of segments of Γ: Nb.
    std::size_t segments() const { return segments_; }
    bool empty() const { return segments_ == 0; }
    /// Slot ids run from 0 to capacity() - 1, dead ones among them.
    std::size_t capacity() const { return slots_.size(); }
    std::uint32_t nextSerial() const { return nextSerial_; }

    /// A→B becomes A→C→B with a new node C. Returns the slot of C.
    SlotId insertAfter(SlotId a, Vec2 position, NodeId node);
    void undoInsertAfter(SlotId a, SlotId c, SegmentMark base);

    /// Takes slot x out of its loop: P→X→N becomes P→N, a new segment.
    void cutOut(SlotId x);
    /// `node`, `position`, `mark`: of the slot x that was cut out after p; `markOfP`: of the segment P→X.
    void undoCutOut(SlotId x, SlotId p, NodeId node, Vec2 position, SegmentMark mark, SegmentMark markOfP);

    /// P→X→N becomes P→C→N: slot x gets the new node C.
    void replace(SlotId x, Vec2 position, NodeId node);
    /// `mark` and `markOfPrev`: of the segments X→N and P→X.
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

    /// A→B becomes A→C and C→B where C is the node of slot s elsewhere on Γ: one loop becomes two, or two become one. s
    /// keeps its outgoing segment and follows A; the returned new slot of the same node takes the incoming one and
    /// leads to B. For an isolated s, that is s itself.
    SlotId connect(SlotId a, SlotId s);
    void undoConnect(SlotId a, SlotId s, SlotId t, SegmentMark base);

    void setRho(SlotId id, double rho) { slots_[index(id)].rho = rho; }
    void setFailureClass(SlotId id, std::uint32_t failureClass) { slots_[index(id)].mark.failureClass = failureClass; }

    /// The part of Γ that comes near the box.
    FrontPart part(const Box2 &box) const;
    /// Takes over a part that has changed inside `box` alone: no link of a slot outside it has. Its nodes from
    /// `firstNew` on get ids greater by `shift`.
    void adopt(const FrontPart &part, const Box2 &box, std::uint32_t firstNew, std::uint32_t shift);

    /// True if the direction from the node of s to p lies strictly inside the free angle of s (exact).
    bool insideAngle(SlotId s, Vec2 p) const;

    /// Links are mutual, lengths and counts right; for tests and assertions.
    bool consistent() const;
    void addTo(Hash64 &hash) const;

  private:
    SlotId allocate();
    void release(SlotId id);
    SlotId revive(SlotId expected, NodeId node, Vec2 position, std::uint32_t face, SegmentMark mark);
    void link(SlotId from, SlotId to);
    void renew(SlotId id);                     ///< its outgoing segment is a new one
    void restore(SlotId id, SegmentMark mark); ///< its outgoing segment is an earlier one again

    std::vector<FrontSlot> slots_;
    std::vector<SlotId> free_;
    std::size_t segments_ = 0;
    std::uint32_t nextSerial_ = 0;
};

/// Segments and isolated points of Γ in some face, with the slots of their ends; links that lead out of it are
/// kNoSlot.
struct FrontPart {
    GenerationFront front;
    std::vector<SlotId> origin; ///< per slot that was taken over: where it comes from, rising
    std::size_t segments = 0;   ///< taken over
};

} // namespace forefront
