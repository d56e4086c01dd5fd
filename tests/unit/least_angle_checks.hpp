#pragma once

#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace forefront::testing {

/// Returns the least angle of an element in degrees.
inline double leastAngleOf(const Mesh &mesh, const Element &e) {
    double least = 180.0;
    for (unsigned k = 0; k < 3; ++k) {
        const Vec2 at = mesh.nodes[index(e[k])];
        const Vec2 u = mesh.nodes[index(e[(k + 1) % 3])] - at, v = mesh.nodes[index(e[(k + 2) % 3])] - at;
        least = std::min(least, std::atan2(cross(u, v), dot(u, v)) * 180.0 / std::numbers::pi);
    }
    return least;
}

/// Returns the number of elements with an angle below a least one, in degrees, by more than rounding.
inline std::size_t elementsBelow(const Mesh &mesh, double angle) {
    const auto elements = mesh.triangles();
    return static_cast<std::size_t>(std::count_if(elements.begin(), elements.end(), [&](const Element &e) {
        return leastAngleOf(mesh, e) < angle * (1.0 - 1e-9);
    }));
}

/// Meshes a job; the test ends if it is refused, or if its mesh is not a valid one of its domain.
inline MeshingOutcome verifiedJob(const MeshingJob &job) {
    Result<MeshingOutcome> outcome = meshDomain(job);
    REQUIRE_MESSAGE(outcome, samples::list(outcome ? Diagnostics{} : outcome.faults()));
    Diagnostics faults = verifyAgainst(outcome->mesh, job.domain, job.spacing.placed.counts());
    std::erase_if(faults, [](const Diagnostic &fault) { return fault.severity != Severity::Error; });
    REQUIRE_MESSAGE(faults.empty(), samples::list(faults));
    return *std::move(outcome);
}

} // namespace forefront::testing
