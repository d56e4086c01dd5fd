#pragma once

#include "core/engine/base/api.hpp"

#include <cstddef>
#include <cstdint>

namespace FOREFRONT_API forefront {

/// Index of a node. Ids have 32 bits: up to 4.29e9 nodes or elements.
enum class NodeId : std::uint32_t {};
/// Index of an element.
enum class ElementId : std::uint32_t {};
/// Index of a slot of the generation front: a front node together with its outgoing front segment.
enum class SlotId : std::uint32_t {};

/// Marks an index that refers to nothing.
inline constexpr std::uint32_t kNoIndex = 0xffffffffU;
inline constexpr NodeId kNoNode{kNoIndex};
inline constexpr ElementId kNoElement{kNoIndex};
inline constexpr SlotId kNoSlot{kNoIndex};

constexpr std::size_t index(NodeId id) {
    return static_cast<std::uint32_t>(id);
}
constexpr std::size_t index(ElementId id) {
    return static_cast<std::uint32_t>(id);
}
constexpr std::size_t index(SlotId id) {
    return static_cast<std::uint32_t>(id);
}

} // namespace forefront
