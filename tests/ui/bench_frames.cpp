#include "tests/ui/edit_driver.hpp"
#include "ui/platform/steady_seconds.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <utility>
#include <vector>

namespace forefront::test {

namespace {

/// Percentiles of times per frame, in ms: CPU time of the whole process (a software renderer draws in its own threads),
/// or wall time for new meshes.
struct FrameTimes {
    double median = 0.0, ninetieth = 0.0, longest = 0.0;
};

FrameTimes percentiles(std::vector<double> times) {
    std::sort(times.begin(), times.end());
    return {times[times.size() / 2], times[times.size() * 9 / 10], times.back()};
}

template <class Change>
FrameTimes timesOfFrames(Driver &driver, int count, Change change) {
    std::vector<double> times;
    for (int i = 0; i < count; ++i) {
        change(i);
        const std::clock_t begin = std::clock();
        driver.frames(1);
        times.push_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    return percentiles(std::move(times));
}

} // namespace

// Not a test; prints figures: forefront_ui_tests --no-skip -tc='Bench*'
TEST_CASE("Bench: CPU time of frames with meshes of four sizes" * doctest::skip()) {
    std::printf("elements,resting_ms,pointer_ms,pan_ms,pan_90_ms,zoom_ms,zoom_90_ms,rest_after_ms,"
                "new_longest_ms,new_90_ms,new_shown_ms,view_bytes_per_element\n");
    for (const double elements : {1e3, 1e5, 1e6, 5e6}) {
        Draughtsman driver;
        driver.platform().show(true);
        driver.rectangle({0, 0}, {8, 8});
        Document sized = driver.document();
        sized.spacing.size = std::sqrt(64.0 / (0.433 * elements));
        driver.context().document.apply(std::move(sized), "Size");
        driver.key('V');
        driver.key(key::kF5);
        driver.settle();
        Driver &d = driver;
        Camera &camera = d.context().view.camera;
        const FrameTimes resting = timesOfFrames(d, 20, [](int) {});
        const FrameTimes pointer = timesOfFrames(
            d, 20, [&](int i) { d.editor().input().push({.kind = InputKind::MouseMove, .x = 400.0 + i, .y = 300.0}); });
        const FrameTimes pan = timesOfFrames(d, 30, [&](int) { camera.centre.x += 0.05; });
        const FrameTimes rest = timesOfFrames(d, 60, [](int) {}); // the mesh is redrawn in parts
        const FrameTimes zoom = timesOfFrames(d, 30, [&](int i) { camera.zoom *= i % 20 < 10 ? 1.03 : 1.0 / 1.03; });
        d.settle();
        std::uint64_t back = 0;
        // A new mesh, from the first frame that shows a part of it to the one that completes it, five times.
        std::vector<double> frames;
        double shown = 0.0;
        for (int k = 0; k < 5; ++k) {
            d.context().run.seek(d.run().known - ++back);
            while (d.context().run.busy()) {
            }
            const std::uint64_t drawn = d.editor().canvas().stillDraws();
            const double begin = steadySeconds();
            while (d.editor().canvas().stillDraws() == drawn) {
                const double before = steadySeconds();
                d.frames(1);
                frames.push_back(1e3 * (steadySeconds() - before));
            }
            shown += 1e3 * (steadySeconds() - begin) / 5.0;
        }
        const FrameTimes fresh = percentiles(std::move(frames));
        std::printf("%zu,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f,%.0f\n", d.run().quality.elements,
                    resting.median, pointer.median, pan.median, pan.ninetieth, zoom.median, zoom.ninetieth,
                    rest.longest, fresh.longest, fresh.ninetieth, shown,
                    static_cast<double>(d.editor().canvas().meshBytes()) /
                        static_cast<double>(d.run().quality.elements));
        std::fflush(stdout);
    }
}

} // namespace forefront::test
