#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

namespace forefront::test {

namespace {

/// Median of the CPU time of the whole process (a software renderer draws in its own threads), in ms per frame.
template <class Change>
double millisecondsAFrame(Driver &driver, int count, Change change) {
    std::vector<double> times;
    for (int i = 0; i < count; ++i) {
        change(i);
        const std::clock_t begin = std::clock();
        driver.frames(1);
        times.push_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    std::nth_element(times.begin(), times.begin() + count / 2, times.end());
    return times[static_cast<std::size_t>(count / 2)];
}

} // namespace

// Not a test; prints figures: forefront_ui_tests --no-skip -tc='Bench*'
TEST_CASE("Bench: CPU time of frames with meshes of three sizes" * doctest::skip()) {
    std::printf("elements,resting_ms,pointer_ms,panning_ms,mesh_new_ms\n");
    for (const double elements : {1e3, 1e5, 1e6}) {
        Draughtsman driver;
        driver.rectangle({0, 0}, {8, 8});
        Document sized = driver.document();
        sized.spacing.size = std::sqrt(64.0 / (0.433 * elements));
        driver.context().document.apply(std::move(sized), "Size");
        driver.key('V');
        driver.key(key::kF5);
        driver.settle();
        Driver &d = driver;
        const double resting = millisecondsAFrame(d, 20, [](int) {});
        const double pointer = millisecondsAFrame(
            d, 20, [&](int i) { d.editor().input().push({.kind = InputKind::MouseMove, .x = 400.0 + i, .y = 300.0}); });
        const double panning = millisecondsAFrame(d, 5, [&](int) { d.context().view.camera.centre.x += 0.05; });
        std::uint64_t back = 0;
        const double fresh = millisecondsAFrame(d, 5, [&](int) {
            d.context().run.seek(d.run().known - ++back);
            while (d.context().run.busy()) {
            }
        });
        std::printf("%zu,%.1f,%.1f,%.1f,%.1f\n", driver.run().quality.elements, resting, pointer, panning, fresh);
        std::fflush(stdout);
    }
}

} // namespace forefront::test
