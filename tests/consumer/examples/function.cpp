// Set the element size by a function of the position.
#include <cmath>
#include <forefront/forefront.hpp>

int main() {
    forefront::MeshingJob job;
    forefront::addLoop(job.domain, {{0, 0}, {4, 0}, {4, 3}, {0, 3}});
    job.spacing.function = [](forefront::Vec2 p) { return 0.05 + 0.1 * std::fabs(p.x - 2.0); };
    job.spacing.functionThreadSafe = true; // it may be called from several threads
    job.options.threads = 2;
    const auto outcome = forefront::meshDomain(job);
    return outcome && outcome->mesh.elementCount() > 1000 ? 0 : 1;
}
