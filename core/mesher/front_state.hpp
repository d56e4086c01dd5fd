#pragma once

#include "core/domain/discretise.hpp"
#include "core/front/base_order.hpp"
#include "core/front/generation_front.hpp"
#include "core/mesh/mesh.hpp"
#include "core/mesher/statistics.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Everything a run consists of besides the background grid: Γ, the order of bases, nodes and elements so far.
struct FrontState {
    explicit FrontState(const DiscreteDomain &boundary);

    GenerationFront front;
    BaseOrder order;
    std::vector<Vec2> nodes;
    std::vector<Element> elements;
    std::vector<std::uint32_t> elementRegions; ///< index of the face; kept only where there are several
    bool manyRegions = false;
    WorkCounters work;
    /// New nodes that may still be made with a size far below the node spacing; keeps the closing guarantee, see
    /// FrontAdvancer.
    std::uint64_t smallNodesLeft = 0;

    std::uint64_t hash() const;
};

/// What one advance did, enough to take it back.
struct AdvanceDelta {
    enum class Kind : std::uint8_t {
        Deferral,  ///< base put back with a higher failure class
        NewNode,   ///< AB -> AC, CB with a new node
        Previous,  ///< apex is the node before A: CA, AB -> CB
        Next,      ///< apex is the node after B: AB, BC -> AC
        Loop,      ///< the last element of a loop of three segments
        Connection ///< apex elsewhere on Γ
    };
    Kind kind = Kind::Deferral;
    bool forced = false;    ///< made by the closing stage
    bool smallNode = false; ///< took one from smallNodesLeft
    SlotId a = kNoSlot;     ///< slot of A
    SlotId b = kNoSlot;     ///< slot of B
    SlotId s = kNoSlot;     ///< slot of the apex: new, before, after or chosen
    SlotId t = kNoSlot;     ///< Connection: the slot that leads to B
    SegmentMark markA;      ///< of AB before
    SegmentMark markB;      ///< of B's outgoing segment before (Next, Loop)
    SegmentMark markS;      ///< of the apex's outgoing segment before (Previous, Loop)
    std::uint32_t delivered = 0, tested = 0, cells = 0, candidates = 0;
};

} // namespace forefront
