#pragma once

#include "core/domain/domain.hpp"
#include "core/mesh/mesh.hpp"

#include <vector>

namespace forefront::testing {

/// [-1,1]² without [0,1]x[-1,0]: a re-entrant corner of 270 degrees at the origin.
Domain lShape();

/// u = r^(2/3)·sin(2θ/3), θ from the positive x axis counter-clockwise: harmonic, zero on both sides of the corner, its
/// gradient infinite there.
double cornerSolution(Vec2 p);

/// Linear finite elements for Δu = 0 on the L-shape with the values of cornerSolution on the whole boundary; the values
/// at the nodes.
std::vector<double> solveCornerProblem(const Mesh &mesh);

/// ‖∇u − ∇u_h‖, the energy error, by numerical integration with element-wise subdivision towards the corner.
double cornerEnergyError(const Mesh &mesh, const std::vector<double> &values);

} // namespace forefront::testing
