#define DOCTEST_CONFIG_IMPLEMENT
#include "tests/support/sanitizers.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cstdio>

#if defined(FOREFRONT_SANITIZED)
// Keeps graphics drivers loaded: they are unloaded before leaks are reported, and the reports would name no function.
extern "C" int dlclose(void *) {
    return 0;
}
#endif

// The order of the tests is shuffled at every run; the printed seed repeats a run: --order-by=rand --rand-seed=N.
int main(int argc, char **argv) {
    doctest::Context context;
    const auto seed = static_cast<int>(std::chrono::steady_clock::now().time_since_epoch().count() & 0x7fffffff);
    context.setOption("order-by", "rand");
    context.setOption("rand-seed", seed);
    context.applyCommandLine(argc, argv);
    std::printf("order seed %d (unless --rand-seed is given)\n", seed);
    return context.run();
}
