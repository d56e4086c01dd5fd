#pragma once

#include "core/engine/quads/quad_watch.hpp"
#include "core/engine/quads/quad_workspace.hpp"

#include <cstddef>

namespace forefront {

/// Joins triangles in pairs: each walks to the nearest other one through the quadrilaterals between them, which it
/// leaves divided the other way, and becomes a quadrilateral with it. No walk crosses a tagged edge. Returns the number
/// of triangles left: in a face with an odd number of edges, at least one. `watch`: learns of each join; null: none.
std::size_t joinTriangles(QuadWorkspace &mesh, QuadWatch *watch = nullptr);

} // namespace forefront
