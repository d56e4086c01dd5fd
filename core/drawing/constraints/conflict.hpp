#pragma once

#include "core/drawing/constraints/document_sketch.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace forefront {

/// Returns constraints of a sketch by name, then joints, such as "Length 1, Length 2 and the joint of wall and polygon
/// 4 at (3, 1)".
std::string relationNames(const DocumentSketch &sketch, const std::set<std::uint32_t> &ids);

/// Returns what to do about a conflict of constraints and joints.
std::string clashAdvice(const DocumentSketch &sketch, const std::set<std::uint32_t> &ids);

/// Returns true if no solution of some constraints and joints of a system is found, however far away: they cannot hold
/// together, as far as numbers can tell. `nearest`: nearestValues() of the system, from which solutions are sought,
/// too.
bool cannotHold(const SketchSystem &system, const std::set<std::uint32_t> &ids, const std::vector<double> &nearest);

/// Constraints and joints that are in each other's way.
struct Clash {
    std::set<std::uint32_t> ids;
    /// True if they cannot hold together: see cannotHold(). False if they have a solution which the solver did not find
    /// from where the drawing is, or only one with corners turned over.
    bool certain = false;
};

/// Returns a clash in a system for which no solution was found: without any one of its constraints, the others have a
/// solution. In a large system some of them may be superfluous. Keeps those that were changed, where it can.
Clash smallestClash(const SketchSystem &system, const std::set<std::uint32_t> &changed);

} // namespace forefront
