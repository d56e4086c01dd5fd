#include "tests/support/meshed_job.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace forefront::testing {

MeshingOutcome meshedJob(const MeshingJob &job) {
    Result<MeshingOutcome> outcome = meshDomain(job);
    REQUIRE_MESSAGE(outcome, toString(outcome ? Diagnostic() : outcome.faults().front()));
    return *std::move(outcome);
}

std::string refusalOf(const MeshingJob &job) {
    const Result<MeshingOutcome> outcome = meshDomain(job);
    return outcome ? std::string() : outcome.faults().front().code;
}

std::size_t edgesTagged(const Mesh &mesh, std::int32_t tag) {
    return static_cast<std::size_t>(
        std::count_if(mesh.edges.begin(), mesh.edges.end(), [tag](const TaggedEdge &edge) { return edge.tag == tag; }));
}

} // namespace forefront::testing
