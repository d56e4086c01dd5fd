#pragma once

#include "core/drawing/sketch/sketch_system.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Whether a constraint can be added to the others.
enum class ConstraintVerdict : std::uint8_t {
    Fine,      ///< it can hold together with the others
    Redundant, ///< the others imply it
    Conflict   ///< no solution was found near by
};

struct ConstraintJudgement {
    ConstraintVerdict verdict = ConstraintVerdict::Fine;
    /// The other constraints that imply it, or that it conflicts with, joints among the latter only. Minimal: without
    /// any of them it would be fine.
    std::vector<std::uint32_t> with;
};

/// Judges a constraint of a sketch whose other constraints hold, or should.
ConstraintJudgement judgeConstraint(const SketchSystem &system, std::uint32_t constraint);

} // namespace forefront
