// Step through a run, forward and back, and explain each advance of the front.
#include <cstdio>
#include <forefront/forefront.hpp>

int main() {
    forefront::MeshingJob job;
    forefront::addLoop(job.domain, {{0, 0}, {4, 0}, {4, 3}, {0, 3}});
    job.spacing.size = 1.0;
    forefront::MeshStepper stepper = forefront::MeshStepper::create(job).value();
    while (stepper.advance() == 1) {
        const auto explanation = stepper.explanation();
        std::printf("%s\n", caption(*explanation, explanation->events.size()).c_str());
    }
    const std::uint64_t end = stepper.position();
    stepper.retreat(2);
    std::printf("%zu segments on the front before the last two advances\n", stepper.front().size());
    return stepper.finish() && stepper.position() == end ? 0 : 1;
}
