#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/source/export_options.hpp"

namespace FOREFRONT_API forefront {

/// Returns the extrusion of a mesh that is given none, in formats that hold solids only: one layer as high as the
/// elements are wide, the side of a square with their mean area.
Extrusion usualExtrusion(const MeshView &mesh);

} // namespace forefront
