// Find out where an input is wrong: places, parts of the domain, advice.
#include <cstdio>
#include <forefront/forefront.hpp>

int main() {
    forefront::MeshingJob job;
    forefront::addLoop(job.domain, {{0, 0}, {4, 0}, {0, 3}, {4, 3}}); // crosses itself
    const auto outcome = forefront::meshDomain(job);
    for (const forefront::Diagnostic &fault : outcome ? forefront::Diagnostics{} : outcome.faults()) {
        std::printf("%s\n", toString(fault).c_str());
        const forefront::Vec2 at = fault.at.value_or(forefront::Vec2{});
        std::printf("at %g %g, %zu parts of the domain\n", at.x, at.y, fault.parts.size());
    }
    return outcome ? 1 : 0;
}
