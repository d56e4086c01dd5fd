#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <chrono>
#include <cstdio>

// The order of the tests is shuffled at every run; the printed seed repeats a run: --order-by=rand --rand-seed=N.
int main(int argc, char **argv) {
    doctest::Context context;
    const auto seed = static_cast<unsigned>(std::chrono::steady_clock::now().time_since_epoch().count() & 0x7fffffff);
    context.setOption("order-by", "rand");
    context.setOption("rand-seed", static_cast<int>(seed));
    context.applyCommandLine(argc, argv);
    std::printf("order seed %u (unless --rand-seed is given)\n", seed);
    return context.run();
}
