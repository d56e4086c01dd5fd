#pragma once

#include "core/engine/mesh/mesh_view.hpp"

namespace forefront::fuzz {

/// Ends the program with the promise on stderr unless it is kept.
void demand(bool kept, const char *promise);

/// Checks that a mesh that was read or made is complete: numbers of nodes, tags, finite coordinates.
void checkMesh(const MeshView &mesh);

} // namespace forefront::fuzz
