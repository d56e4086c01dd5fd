#pragma once

#include "core/drawing/constraints/document_sketch.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>
#include <set>
#include <string>

namespace forefront {

/// Returns constraints of a sketch by name, then joints, such as "Length 1, Length 2 and the joint of wall and polygon
/// 4 at (3, 1)".
std::string relationNames(const DocumentSketch &sketch, const std::set<std::uint32_t> &ids);

/// Returns what to do about a conflict of constraints and joints.
std::string clashAdvice(const DocumentSketch &sketch, const std::set<std::uint32_t> &ids);

/// Returns constraints and joints of a system without a solution that cannot hold together: without any of them, a
/// solution of the others is found. In a large system some of them may be superfluous. Keeps those that were changed,
/// where it can.
std::set<std::uint32_t> smallestClash(const SketchSystem &system, const std::set<std::uint32_t> &changed);

} // namespace forefront
