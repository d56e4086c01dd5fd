#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/domain/domain.hpp"

#include <span>

namespace FOREFRONT_API forefront {

/// Adds a closed polygon: its nodes and the boundary segments between them.
inline void addLoop(Domain &domain, std::span<const Vec2> nodes, std::int32_t tag = 1) {
    const auto first = static_cast<std::uint32_t>(domain.nodes.size());
    const auto count = static_cast<std::uint32_t>(nodes.size());
    domain.nodes.insert(domain.nodes.end(), nodes.begin(), nodes.end());
    for (std::uint32_t i = 0; i < count; ++i) {
        domain.segments.push_back({first + i, first + (i + 1) % count, tag, SegmentRole::Boundary});
    }
}

} // namespace forefront
