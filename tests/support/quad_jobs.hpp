#pragma once

#include "core/engine/mesher/options.hpp"
#include "core/engine/quads/coloured_mesher.hpp"
#include "core/engine/session/mesh_stepper.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace forefront::testing {

/// The nodes of a regular polygon about the origin.
std::vector<Vec2> discOutline(unsigned count, double radius);

/// A wheel with five teeth of six nodes each, on the circles of radius 1, 1.24 and 1.4.
std::vector<Vec2> gearOutline();

/// A job of quadrilaterals in an outline, with a size function.
MeshingJob steppedQuads(const std::vector<Vec2> &outline, const std::string &spacing);

/// Jobs whose fronts differ: a lattice, rows to the end, a graded spacing, two regions, kept odd edges, squares whose
/// second half is refused, mixed elements.
std::map<std::string, MeshingJob> steppedJobs();

/// Returns a stepper at the start of a run.
MeshStepper quadStepper(const MeshingJob &job);

/// Returns the hash of the mesh of a job that is run without steps.
std::uint64_t hashOfMeshed(const MeshingJob &job);

/// Returns a front of quadrilaterals at its start, and the boundary that it has coloured. `rows`: see
/// ColouredMesher::create().
std::unique_ptr<ColouredMesher> colouredMesher(const MeshingJob &job, std::uint32_t rows,
                                               std::shared_ptr<const ColouredBoundary> &boundary);

} // namespace forefront::testing
