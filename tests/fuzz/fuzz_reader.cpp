#include "tests/fuzz/fuzz_targets.hpp"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    static const forefront::fuzz::Target *const target = forefront::fuzz::find(FOREFRONT_FUZZ_READER);
    target->run({reinterpret_cast<const char *>(data), size});
    return 0;
}
