#pragma once

#include "core/engine/mesher/timeline.hpp"
#include "core/engine/session/breakpoints.hpp"

#include <optional>

namespace forefront {

/// Returns the first enabled condition, in the order of StopKind, that the last advance of the timeline fulfils; none
/// at its start. For Cell, the advance may be repeated with recording, which does not change the timeline.
std::optional<Stop> stopAfterLast(const Breakpoints &breakpoints, Timeline &timeline);

/// Finds the node or edge within `tolerance` of a place, otherwise the element around it, among the elements made so
/// far, and the advance that made it. For a node of the boundary, that is the advance of its first element.
std::optional<Birth> birthAt(const Timeline &timeline, Vec2 place, double tolerance);

/// Returns true if a place is not meshed yet: it lies inside the loops of Γ.
bool unmeshed(const GenerationFront &front, Vec2 place);

} // namespace forefront
