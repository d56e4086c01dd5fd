#pragma once

#include "core/drawing/sketch/sketch_system.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace forefront {

/// Gives the unknowns of each group that equations make equal the same bits, where a solution has them up to its
/// tolerance: coincident nodes are one node of a domain only then. Held unknowns and those of given value lead their
/// group, then those of least `rank`, then the first.
void equaliseValues(const SketchSystem &system, std::span<const std::uint32_t> equations, std::vector<double> &values,
                    const std::function<int(std::uint32_t)> &rank);

} // namespace forefront
