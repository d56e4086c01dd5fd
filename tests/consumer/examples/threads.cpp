// Mesh several domains at once: jobs share nothing, and each may use several threads.
#include <forefront/forefront.hpp>
#include <future>

int main() {
    std::vector<std::future<std::uint64_t>> hashes;
    for (const unsigned threads : {1U, 1U, 2U}) {
        hashes.push_back(std::async(std::launch::async, [threads] {
            forefront::MeshingJob job;
            forefront::addLoop(job.domain, {{0, 0}, {4, 0}, {4, 3}, {0, 3}});
            job.spacing.size = 0.05;
            job.options.threads = threads;
            return forefront::meshHash(forefront::meshDomain(job).value().mesh);
        }));
    }
    const std::uint64_t first = hashes[0].get();
    return hashes[1].get() == first && hashes[2].get() == first ? 0 : 1;
}
