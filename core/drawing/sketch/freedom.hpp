#pragma once

#include "core/drawing/sketch/sketch_system.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace forefront {

/// What the equations of a sketch leave free at its values, to first order.
struct SketchFreedom {
    std::size_t degrees = 0;              ///< of freedom, of all unknowns that are not held
    std::vector<bool> determined;         ///< for each unknown, whether it cannot move
    std::vector<std::uint32_t> redundant; ///< constraints that follow from constraints before them, in order
};

SketchFreedom freedomOf(const SketchSystem &system);

} // namespace forefront
