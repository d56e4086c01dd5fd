#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/geometry/rigid_map.hpp"

#include <cstdint>

namespace FOREFRONT_API forefront {

/// Two parts of the boundary that are divided alike: the second one is the first one, moved or turned.
struct PeriodicSpec {
    std::int32_t from = 1; ///< tag of the part that is divided
    std::int32_t to = 2;   ///< tag of its image

    friend bool operator==(const PeriodicSpec &, const PeriodicSpec &) = default;
};

/// Two parts of the boundary and the motion that takes the first one to the second.
struct PeriodicLink {
    std::int32_t from = 1; ///< tag
    std::int32_t to = 2;   ///< tag
    RigidMap map;

    friend bool operator==(const PeriodicLink &, const PeriodicLink &) = default;
};

/// How far the image of a node of a periodic part may be from the node of the other part, relative to the diagonal of
/// the domain: as far as verification allows a node to be from its segment.
inline constexpr double kPeriodicTolerance = 1e-9;

} // namespace forefront
