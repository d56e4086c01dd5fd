#include "core/engine/base/result.hpp"

#include <cstdio>
#include <cstdlib>

namespace forefront {

void abortWithoutValue(const Diagnostics &faults) {
    const std::string fault = faults.empty() ? "error: no value, and no diagnostics" : toString(faults.front());
    std::fprintf(stderr, "%s\nforefront: the value of a failed result was used; check the result first\n",
                 fault.c_str());
    std::abort();
}

void abortWithoutFaults() {
    std::fputs("forefront: the diagnostics of a successful result were used; check the result first\n", stderr);
    std::abort();
}

} // namespace forefront
