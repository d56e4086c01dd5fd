#pragma once

#include "core/engine/mesh/mesh_view.hpp"

namespace forefront {

class SpacingField;

/// Returns the spacing conformity over the area of a mesh: the mean, weighted by area, of min(h/ρ, ρ/h) at the centres
/// of the elements, where h is the size of the element, √(4A/√3) for a triangle of area A and √A for a quadrilateral.
/// Quadrilaterals count as two triangles of their size, and elements whose value is below 0.8 in up to 64 parts. Unlike
/// the mean over the edges, it shows a spacing that is ignored inside elements. Elements without a positive area do not
/// count; 0 if there are no others.
double conformityOverArea(const MeshView &mesh, const SpacingField &spacing);

} // namespace forefront
