#include "core/files/files.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/dialogs/open_mesh.hpp"
#include "ui/platform/steady_seconds.hpp"

#include <doctest/doctest.h>
#include <glad/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>
#include <thread>

namespace forefront::test {

namespace {

double cpuSeconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Draws frames as the main loop does, only when there is something new, until `condition` holds. Returns the wall time
/// of the longest frame, in seconds.
template <class Condition>
double runUntil(Driver &driver, Condition condition) {
    double longest = 0.0;
    while (!condition()) {
        if (driver.editor().needsFrame()) {
            const double begin = steadySeconds();
            driver.frames(1);
            glFinish(); // a window waits for each frame; without this, a later frame would wait for several
            longest = std::max(longest, steadySeconds() - begin);
        } else {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    return longest;
}

} // namespace

// Not a test; prints figures: forefront_ui_tests --no-skip -tc='Bench*open*'
TEST_CASE("Bench: time to open a mesh of a million triangles, to compare it, and to drop it" * doctest::skip()) {
    const TemporaryFolder folder;
    std::printf("file,elements,shown_s,cpu_s,read_longest_frame_ms,shown_longest_frame_ms,compare_longest_frame_ms,"
                "esc_answered_ms,esc_settled_ms\n");
    for (const char *format : {"msh41-binary", "vtu"}) {
        const auto file = folder / (std::string("mesh.") + (format[0] == 'v' ? "vtu" : "msh"));
        {
            Draughtsman maker;
            maker.rectangle({0, 0}, {8, 8});
            Document sized = maker.document();
            sized.spacing.size = std::sqrt(64.0 / (0.433 * 1e6));
            maker.context().document.apply(std::move(sized), "Size");
            maker.key(key::kF5);
            maker.settle();
            REQUIRE_FALSE(hasErrors(writeMesh(file, maker.run().mesh->mesh, format)));
        }
        Driver driver({.sample = false}, {1280, 800}, 1.0, true);
        openMesh(driver.context(), file);
        runUntil(driver, [&] { return driver.has("canvas/task"); });
        const double pressed = steadySeconds();
        driver.key(key::kEscape);
        const double answered = steadySeconds() - pressed;
        driver.settle();
        const double settled = steadySeconds() - pressed;

        const double begin = steadySeconds(), cpu = cpuSeconds();
        openMesh(driver.context(), file);
        const double longest = runUntil(driver, [&] { return driver.context().run.showsFile(); });
        const double shown = steadySeconds() - begin, used = cpuSeconds() - cpu;
        const auto settledDown = [&] { return driver.editor().settled(); };
        const double drawn = runUntil(driver, settledDown);
        compareMesh(driver.context(), file);
        const double compared = runUntil(driver, settledDown);
        std::printf("%s,%zu,%.2f,%.2f,%.0f,%.0f,%.0f,%.0f,%.0f\n", format, driver.run().quality.elements, shown, used,
                    1e3 * longest, 1e3 * drawn, 1e3 * compared, 1e3 * answered, 1e3 * settled);
        std::fflush(stdout);
    }
}

} // namespace forefront::test
