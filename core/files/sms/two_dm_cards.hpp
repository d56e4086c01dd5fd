#pragma once

#include "core/engine/mesh/cell.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace forefront {

/// The cards of elements.
struct TwoDmCard {
    std::string_view name;
    CellKind kind;
};
inline constexpr std::array kTwoDmCards = {TwoDmCard{"E3T", CellKind::Triangle3}, TwoDmCard{"E6T", CellKind::Triangle6},
                                           TwoDmCard{"E4Q", CellKind::Quadrilateral4},
                                           TwoDmCard{"E8Q", CellKind::Quadrilateral8},
                                           TwoDmCard{"E9Q", CellKind::Quadrilateral9}};

/// Returns the place in the order of CellTraits of node k of an element. Nodes of elements of second order run around
/// them: corner, middle, corner, middle; one in the centre comes last.
constexpr std::uint8_t twoDmNode(const CellTraits &traits, std::size_t k) {
    const std::size_t around = 2U * traits.corners;
    return static_cast<std::uint8_t>(traits.order == 1 || k >= around ? k
                                     : k % 2 == 0                     ? k / 2
                                                                      : traits.corners + k / 2);
}

} // namespace forefront
