// Mesh a plate with a hole, with tags and names for its boundary and its region.
#include <forefront/forefront.hpp>

int main() {
    forefront::MeshingJob job;
    forefront::addLoop(job.domain, {{0, 0}, {4, 0}, {4, 3}, {0, 3}}, 1);
    forefront::addLoop(job.domain, {{1, 1}, {2, 1}, {2, 2}, {1, 2}}, 2);
    job.domain.boundaryNames = {{1, "outer"}, {2, "hole"}};
    job.domain.regionMarkers = {{.at = {0.5, 0.5}, .tag = 7}};
    job.domain.regionNames = {{7, "steel"}};
    job.spacing.size = 0.25;
    const auto outcome = forefront::meshDomain(job);
    return outcome && !hasErrors(forefront::writeMesh("plate.msh", outcome->mesh)) ? 0 : 1;
}
