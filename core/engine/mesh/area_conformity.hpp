#pragma once

#include "core/engine/mesh/mesh_view.hpp"

namespace forefront {

class SpacingField;

/// Returns the spacing conformity over the area of a mesh: the mean over all places of min(h/ρ, ρ/h), where h is the
/// size of the element there, √(4A/√3) for a triangle of area A and √A for a quadrilateral. Unlike the mean over the
/// edges, it shows a spacing that is ignored inside elements. Elements without a positive area do not count; 0 if there
/// are no others.
double conformityOverArea(const MeshView &mesh, const SpacingField &spacing);

} // namespace forefront
