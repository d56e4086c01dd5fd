#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/diagnostic.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// Numbers of shapes that constraints hold elsewhere than where a user wanted them.
struct HeldNumbers {
    std::string numbers;            ///< such as "x = 5 of node 3"
    std::string names;              ///< of the constraints and joints, as few as possible; empty if they are not known
    std::vector<std::uint32_t> ids; ///< of these constraints
};

/// Compares the numbers that a user has changed, from `before` to `wanted`, with what the constraints made of them.
/// Returns those that are not as wanted, with the constraints that they cannot hold together with; none if all are. In
/// a large sketch the constraints are not sought, which would take long.
std::optional<HeldNumbers> heldNumbers(const Document &before, const Document &wanted, const Document &settled);

/// Returns the error constraint-conflict for such numbers, with the ids of the constraints; empty if all are as wanted.
Diagnostics heldNumbersFault(const Document &before, const Document &wanted, const Document &settled);

} // namespace forefront
