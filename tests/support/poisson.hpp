#pragma once

#include "core/engine/domain/domain.hpp"
#include "core/engine/mesh/tri_mesh.hpp"

#include <vector>

namespace forefront::testing {

/// Returns [-1,1]² without [0,1]x[-1,0], which has a re-entrant corner of 270 degrees at the origin.
Domain lShape();

/// Returns u = r^(2/3)·sin(2θ/3), with θ counter-clockwise from the positive x axis: harmonic, zero on both sides of
/// the corner, its gradient infinite there.
double cornerSolution(Vec2 p);

/// Solves Δu = 0 on the L-shape by linear finite elements, with the values of cornerSolution on the entire boundary,
/// and returns the values at the nodes.
std::vector<double> solveCornerProblem(const TriMesh &mesh);

/// Returns the energy error ‖∇u − ∇u_h‖, integrated numerically with elements subdivided towards the corner.
double cornerEnergyError(const TriMesh &mesh, const std::vector<double> &values);

} // namespace forefront::testing
