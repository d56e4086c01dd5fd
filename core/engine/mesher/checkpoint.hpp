#pragma once

#include "core/engine/mesher/front_state.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace forefront {

/// What a method keeps in a checkpoint besides the state of the front.
struct CheckpointPart {
    virtual ~CheckpointPart() = default;
    virtual std::size_t bytes() const = 0;
};

/// The state of a run at a position of its timeline, without its nodes and elements, which every later position
/// begins with. Its size depends on the length of Γ, not on the size of the mesh.
struct Checkpoint {
    GenerationFront front;
    WalkOrder walkOrder; ///< without history: the run cannot retreat beyond the checkpoint
    Walk walk;
    std::uint32_t strip = 0;
    WorkCounters work;
    std::uint64_t smallNodesLeft = 0;
    std::size_t nodes = 0, elements = 0;        ///< numbers of nodes and elements made so far
    std::shared_ptr<const CheckpointPart> part; ///< null: the method keeps nothing else

    explicit Checkpoint(const FrontState &state)
        : front(state.front), walkOrder(state.walkOrder.withoutHistory()), walk(state.walk), strip(state.strip),
          work(state.work), smallNodesLeft(state.smallNodesLeft), nodes(state.nodes.size()),
          elements(state.elements.size()) {}
    std::size_t bytes() const { return sizeof *this + front.bytes() + walkOrder.bytes() + (part ? part->bytes() : 0); }
};

} // namespace forefront
