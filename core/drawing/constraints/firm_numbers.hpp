#pragma once

#include "core/drawing/sketch/solve_sketch.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace forefront {

/// Which numbers of a sketch should keep their values while it is solved; by unknown.
struct FirmNumbers {
    std::vector<bool> firm;     ///< what a command moved, and the other numbers of the shapes that it moved
    std::vector<bool> standing; ///< of neighbours, away from the joints; not firm
};

/// Solves a system; returns none if it fails.
using SystemSolver = std::function<std::optional<SketchSolution>(const SketchSystem &)>;

/// Solves a system so that what a command moved keeps its values, and as little as possible of its neighbours moves:
/// first only what is at the joints, then what stands beside what does not hold, and so on outwards. None if there is
/// no such solution without flips.
std::optional<SketchSolution> solveAroundFirm(const SketchSystem &system, const FirmNumbers &numbers,
                                              const SystemSolver &solver);

/// Returns which of some unknowns can keep their values together, those first in order before others; by unknown. After
/// many attempts the rest is left free.
std::vector<bool> keepInOrder(const SketchSystem &system, std::span<const std::uint32_t> unknowns,
                              const SystemSolver &solver);

} // namespace forefront
