#pragma once

#include "core/drawing/constraints/document_sketch.hpp"
#include "core/drawing/sketch/solve_sketch.hpp"

#include <cstdint>
#include <optional>
#include <set>

namespace forefront {

/// Solves a system of a sketch so that one of several shapes moves alone, and keeps its radii and axes if it can: the
/// one that moves least; of equal ones, the last drawn. None if there are fewer than two, or no such solution without
/// flips.
std::optional<SketchSolution> solveMovingOne(const DocumentSketch &sketch, const SketchSystem &system,
                                             const std::set<std::uint32_t> &shapes);

} // namespace forefront
