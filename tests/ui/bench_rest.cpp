#include "tests/ui/edit_driver.hpp"
#include "ui/platform/steady_seconds.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <string>
#include <thread>

namespace forefront::test {

namespace {

/// Runs the main loop for a while without input and prints the CPU time and the frames that it takes.
void rest(Driver &driver, const std::string &what) {
    constexpr double kSeconds = 10.0;
    driver.settle();
    Editor &editor = driver.editor();
    const std::uint64_t frames = editor.frames();
    const std::clock_t cpu = std::clock();
    const double begin = steadySeconds();
    while (steadySeconds() - begin < kSeconds) {
        std::this_thread::sleep_for(std::chrono::duration<double>(editor.sleepSeconds()));
        if (editor.needsFrame()) {
            editor.frame();
        }
    }
    std::printf("%s,%.2f,%llu\n", what.c_str(),
                1e3 * static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC / kSeconds,
                static_cast<unsigned long long>(editor.frames() - frames));
    std::fflush(stdout);
}

} // namespace

// Not a test; prints figures: forefront_ui_tests --no-skip -tc='Bench*rest*'
TEST_CASE("Bench: CPU time of a window at rest" * doctest::skip()) {
    std::printf("shows,cpu_ms_per_s,frames_in_10_s\n");
    Draughtsman driver;
    driver.platform().show(true);
    rest(driver, "nothing");
    driver.rectangle({0, 0}, {8, 8});
    Document sized = driver.document();
    sized.spacing.size = std::sqrt(64.0 / (0.433 * 1e6));
    driver.context().document.apply(std::move(sized), "Size");
    driver.key('V');
    driver.key(key::kF5);
    for (const char *tab : {"log", "statistics", "histogram", "probe"}) {
        driver.showPanel(tab);
        driver.context().animate();
        rest(driver, "a million triangles and " + std::string(tab));
    }
}

} // namespace forefront::test
