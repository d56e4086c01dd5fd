#pragma once

#include "core/engine/mesh/mesh_view.hpp"

#include <optional>

namespace forefront::testing {

/// Which corners below a degree force a flat quadrilateral.
enum class ForcingCorners {
    Given, ///< those of the domain: between two tagged edges
    Any    ///< those between the tops of boundary layers, too
};

/// Returns the place of a quadrilateral with a corner of 180 degrees or more, unless one of its other corners forces
/// it. Of curved elements, the corners count.
std::optional<Vec2> unforcedFlatPlace(const MeshView &mesh, ForcingCorners forcing = ForcingCorners::Given);

} // namespace forefront::testing
