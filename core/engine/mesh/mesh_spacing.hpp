#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <memory>

namespace FOREFRONT_API forefront {

/// Returns the sizes of the elements of a mesh as a background mesh, so that a domain can be meshed as finely as that
/// mesh is. An element has the edge length of the regular triangle or square with its area; a node has the mean of the
/// density 1/h² around it, weighted by area. Null if no element has an area.
std::shared_ptr<const BackgroundMesh> spacingOfMesh(const MeshView &mesh);

} // namespace forefront
