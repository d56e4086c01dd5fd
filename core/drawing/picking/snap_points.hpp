#pragma once

#include "core/drawing/picking/pointer_snap.hpp"

#include <optional>

namespace forefront {

/// Returns the nearest special point of the drawing within the tolerance of a query: the middle of a segment, the
/// centre of an arc or a rectangle, a place where segments cross, and, for a query that draws from an anchor, where a
/// line from there meets a segment at a right angle or touches a curve.
std::optional<Snapped> specialPoint(const PickIndex &index, const SnapQuery &query);

} // namespace forefront
