#include "tests/fuzz/fuzz_targets.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace {

/// Returns the target that the environment variable FUZZ_READER names; ends the program if there is none.
const forefront::fuzz::Target &chosen() {
    const char *const name = std::getenv("FUZZ_READER");
    const auto *const target = name != nullptr ? forefront::fuzz::find(name) : nullptr;
    if (target == nullptr) {
        std::fputs("set FUZZ_READER to one of:", stderr);
        for (const auto &known : forefront::fuzz::targets()) {
            std::fprintf(stderr, " %s", known.name);
        }
        std::fputs("\n", stderr);
        std::exit(2);
    }
    return *target;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    static const forefront::fuzz::Target &target = chosen();
    target.run({reinterpret_cast<const char *>(data), size});
    return 0;
}
