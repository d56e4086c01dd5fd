#include "app/batch/exit_code.hpp"

#include <cstdio>

namespace forefront {

void printFaults(const Diagnostics &faults) {
    for (const Diagnostic &fault : faults) {
        std::fprintf(stderr, "%s\n", toString(fault).c_str());
    }
}

} // namespace forefront
