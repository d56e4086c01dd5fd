#pragma once

#include "core/boundary/discretise.hpp"
#include "core/front/base_order.hpp"
#include "core/front/generation_front.hpp"
#include "core/front/walk_order.hpp"
#include "core/mesh/mesh.hpp"
#include "core/mesher/front_care.hpp"
#include "core/mesher/front_regions.hpp"
#include "core/mesher/statistics.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace forefront {

/// Where the fast method stands in its walk along the loops of Γ.
struct Walk {
    SlotId base = kNoSlot;   ///< the segment to go on with: in no queue; kNoSlot: take one from the order
    std::uint32_t level = 0; ///< class of length of the segment that the walk began with: it ends at longer ones
};

/// Everything a run consists of besides the background grid: Γ, the order of bases, nodes and elements so far.
struct FrontState {
    explicit FrontState(const DiscreteDomain &boundary, const FrontCare &howCareful = {});
    /// For a part of Γ that is advanced alone, in one region: new nodes get the ids from `firstNew` on. Reads neither
    /// nodes nor elements of `whole`.
    FrontState(const FrontState &whole, GenerationFront part, std::uint32_t onlyRegion, std::uint32_t firstNew);

    GenerationFront front;
    BaseOrder order; ///< of the classic method
    FrontCare care;  ///< of the fast method, as what follows
    WalkOrder walkOrder;
    Walk walk;
    std::shared_ptr<const FrontRegions> regions; ///< never null
    std::uint32_t region = 0;                    ///< the present one
    std::uint32_t regionEnd = 1;                 ///< after the last to be worked on
    std::uint32_t firstNode = 0;                 ///< id of nodes[0]
    std::vector<Vec2> nodes;
    std::vector<Element> elements;
    std::vector<std::uint32_t> elementRegions; ///< index of the face; kept only where there are several
    bool manyRegions = false;
    WorkCounters work;
    /// New nodes that may still be made with a size far below the node spacing; keeps the closing guarantee, see
    /// ClassicAdvancer.
    std::uint64_t smallNodesLeft = 0;

    std::uint64_t hash() const;
};

/// What one advance did, enough to take it back.
struct AdvanceDelta {
    enum class Kind : std::uint8_t {
        Deferral,   ///< base put back with a higher failure class
        NewNode,    ///< AB -> AC, CB with a new node
        Previous,   ///< apex is the node before A: CA, AB -> CB
        Next,       ///< apex is the node after B: AB, BC -> AC
        Loop,       ///< the last element of a loop of three segments
        Connection, ///< apex elsewhere on Γ
        Two,        ///< AB, BN -> AC, CN with a new node over two segments
        Three       ///< AB, BS, SN -> AC, CN with a new node over three
    };
    Kind kind = Kind::Deferral;
    bool forced = false;      ///< made by the closing stage
    bool smallNode = false;   ///< took one from smallNodesLeft
    SlotId a = kNoSlot;       ///< slot of A
    SlotId b = kNoSlot;       ///< slot of B
    SlotId s = kNoSlot;       ///< slot of the apex: new, before, after or chosen
    SlotId t = kNoSlot;       ///< Connection: the slot that leads to B
    SegmentMark markA;        ///< of AB before
    SegmentMark markB;        ///< of B's outgoing segment before (Next, Loop, Two, Three)
    SegmentMark markS;        ///< of the outgoing segment of s before (Previous, Loop, Three)
    Walk walk;                ///< before
    std::uint32_t region = 0; ///< before
    std::uint32_t logged = 0; ///< size of the log of the order before
    std::uint32_t delivered = 0, tested = 0, cells = 0, candidates = 0;

    /// Elements made.
    unsigned elements() const {
        return kind == Kind::Deferral ? 0U : kind == Kind::Two ? 2U : kind == Kind::Three ? 3U : 1U;
    }
};

} // namespace forefront
