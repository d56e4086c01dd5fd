// Show the progress, and cancel from another thread.
#include <cstdio>
#include <forefront/forefront.hpp>
#include <thread>

int main() {
    forefront::MeshingJob job;
    forefront::addLoop(job.domain, {{0, 0}, {4, 0}, {4, 3}, {0, 3}});
    job.spacing.size = 0.002;
    std::stop_source stop;
    const auto report = [](std::string_view stage, double part) {
        std::printf("%.*s %.2f\n", static_cast<int>(stage.size()), stage.data(), part);
    };
    const std::jthread canceller([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        stop.request_stop();
    });
    const auto outcome = forefront::meshDomain(job, {report, stop.get_token()});
    return !outcome && outcome.faults().front().code == "cancelled" ? 0 : 1;
}
