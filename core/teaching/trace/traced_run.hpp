#pragma once

#include "core/engine/base/vec2.hpp"
#include "core/engine/mesher/trace.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace forefront {

/// A candidate node of a traced advance.
struct TracedCandidate {
    Vec2 at;
    std::optional<double> score;
    std::optional<Verdict> verdict;
};

/// An advance as a trace file tells it. A program that is compared with ours has to give the base; every other part
/// is compared only if it is there.
struct TracedAdvance {
    Vec2 a, b; ///< base segment AB
    std::optional<double> rho;
    std::optional<Vec2> ideal;
    std::optional<std::vector<TracedCandidate>> candidates;
    std::optional<std::vector<std::array<Vec2, 3>>> elements; ///< corners of those made; empty: AB was deferred
    std::optional<std::uint64_t> front;                       ///< segments of Γ after the advance
    std::size_t offset = 0;                                   ///< byte of the file where it begins
};

} // namespace forefront
