#pragma once

#include "core/engine/boundary/discretise.hpp"
#include "core/engine/front/base_order.hpp"
#include "core/engine/front/generation_front.hpp"
#include "core/engine/front/walk_order.hpp"
#include "core/engine/mesh/tri_mesh.hpp"
#include "core/engine/mesher/front_care.hpp"
#include "core/engine/mesher/front_rules.hpp"
#include "core/engine/mesher/front_strips.hpp"
#include "core/engine/mesher/statistics.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace forefront {

/// The position of the fast method in its walk along the loops of Γ.
struct Walk {
    SlotId base = kNoSlot;   ///< next segment of the walk, not in the queue; kNoSlot: take one from the queue
    std::uint32_t level = 0; ///< class of the first segment of the walk (WalkOrder::levelOf); longer ones end it
};

/// The state of a run without its background grid: Γ, the order of bases, and the nodes and elements so far.
struct FrontState {
    explicit FrontState(const DiscreteDomain &boundary, const FrontCare &frontCare = {},
                        const FrontRules &frontRules = {});
    /// The state of a part of Γ that advances alone, in one strip. New nodes get ids from `firstNew` on. Reads neither
    /// the nodes nor the elements of `whole`.
    FrontState(const FrontState &whole, GenerationFront part, std::uint32_t onlyStrip, std::uint32_t firstNew);

    GenerationFront front;
    FrontRules rules;    ///< classic method
    BaseOrder order;     ///< classic method
    FrontCare care;      ///< fast method, like the members below
    WalkRules walkRules; ///< of the whole run; `walkOrder` adopts them when it is cleared
    WalkOrder walkOrder;
    Walk walk;
    std::shared_ptr<const FrontStrips> strips; ///< never null
    std::uint32_t strip = 0;                   ///< the current one
    std::uint32_t stripEnd = 1;                ///< one past the last strip of this run
    std::uint32_t firstNode = 0;               ///< id of nodes[0]
    std::vector<Vec2> nodes;
    std::vector<Element> elements;
    std::vector<std::uint32_t> elementFaces; ///< index of each element's face; only where there are several
    bool manyFaces = false;
    WorkCounters work;
    /// Number of further new nodes that may be far closer to Γ than the node spacing. The limit guarantees that the
    /// front closes; see ClassicAdvancer.
    std::uint64_t smallNodesLeft = 0;

    /// Returns a hash of the state: equal for states that are equal bit for bit. Work that depends on the grid is left
    /// out.
    std::uint64_t hash() const;
};

/// The changes of one advance, enough to undo it.
struct AdvanceDelta {
    enum class Kind : std::uint8_t {
        Deferral,   ///< base put back with a higher failure class
        NewNode,    ///< AB -> AC, CB with a new node
        Previous,   ///< apex is the node before A: CA, AB -> CB
        Next,       ///< apex is the node after B: AB, BC -> AC
        Loop,       ///< the last element of a loop of three segments
        Connection, ///< apex elsewhere on Γ
        Two,        ///< AB, BN -> AC, CN with a new node over two segments
        Three,      ///< AB, BS, SN -> AC, CN with a new node over three
        Opening,    ///< two-coloured front: NewNode twice, recorded elsewhere
        Closing     ///< two-coloured front: Next twice, recorded elsewhere
    };
    Kind kind = Kind::Deferral;
    bool forced = false;       ///< made by the closing stage
    bool smallNode = false;    ///< counted against smallNodesLeft
    std::uint8_t rejected = 0; ///< candidates tested and rejected; 255: that many or more
    SlotId a = kNoSlot;        ///< slot of A
    SlotId b = kNoSlot;        ///< slot of B
    SlotId s = kNoSlot;        ///< slot of the apex: new, previous, next or elsewhere
    SlotId t = kNoSlot;        ///< Connection: the slot that leads to B
    SegmentMark markA;         ///< mark of AB before the advance
    SegmentMark markB;         ///< mark of the segment from B before the advance (Next, Loop, Two, Three)
    SegmentMark markS;         ///< mark of the segment from s before the advance (Previous, Loop, Three)
    Walk walk;                 ///< before the advance
    std::uint32_t strip = 0;   ///< before the advance
    std::uint32_t logged = 0;  ///< size of the log of the order before the advance
    std::uint32_t delivered = 0, considered = 0, tested = 0, cells = 0, candidates = 0;

    /// Returns the number of elements made.
    unsigned elements() const {
        switch (kind) {
        case Kind::Deferral:
            return 0;
        case Kind::Two:
        case Kind::Opening:
        case Kind::Closing:
            return 2;
        case Kind::Three:
            return 3;
        case Kind::NewNode:
        case Kind::Previous:
        case Kind::Next:
        case Kind::Loop:
        case Kind::Connection:
            break;
        }
        return 1;
    }
    /// Returns the change in the number of segments of Γ.
    int growth() const;
};

} // namespace forefront
