#pragma once

#include "core/engine/mesh/mesh_view.hpp"

#include <optional>

namespace forefront::testing {

/// Returns the place of a quadrilateral with a corner of 180 degrees or more, unless one of its other corners forces
/// it: one below a degree between two tagged edges. Of curved elements, the corners count.
std::optional<Vec2> unforcedFlatPlace(const MeshView &mesh);

} // namespace forefront::testing
