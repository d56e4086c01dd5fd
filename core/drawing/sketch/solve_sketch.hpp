#pragma once

#include "core/drawing/sketch/sketch_system.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace forefront {

/// The solution of a sketch nearest to what the user sees.
struct SketchSolution {
    std::vector<double> values; ///< of all unknowns
    std::size_t flips = 0;      ///< corners that have changed their side, or edges and radii that nearly vanished
};

/// How much a solver tries.
enum class SolveEffort : std::uint8_t {
    Plain, ///< a plain solve only, quick where there may be no solution
    Full   ///< all ways
};

/// Solves the parts of a sketch that do not hold, after an edit such as a new dimension. Tries a plain solve first,
/// then ways that keep corners: limited steps, small parts of the change, nearby starts. Takes the first solution
/// without flips, else the one with fewest. Returns none if no solution is found near by. Parts that hold keep their
/// bits.
std::optional<SketchSolution> solveSketch(const SketchSystem &system, SolveEffort effort = SolveEffort::Full);

/// Returns true if some equations have a solution near the values of a sketch.
bool solvable(const SketchSystem &system, std::span<const std::uint32_t> equations);

/// Returns true if some equations have a solution, sought near the values of a sketch first, then from many starts that
/// are larger, smaller or scattered. If none of these leads to one, there is none, as far as numbers can tell. Takes
/// long.
bool solvableFromAfar(const SketchSystem &system, std::span<const std::uint32_t> equations);

/// Returns values near those of a sketch without a solution that violate its equations as little as possible. From
/// there it is a short way to solutions without one of the equations that are in each other's way.
std::vector<double> nearestValues(const SketchSystem &system);

/// Returns true if a sketch has a solution without flips near its values or near others.
bool hasCleanSolution(const SketchSystem &system, const std::vector<double> &others);

/// Returns true if all of some equations hold, up to rounding of the coordinates.
bool holds(const SketchSystem &system, std::span<const std::uint32_t> equations);

} // namespace forefront
