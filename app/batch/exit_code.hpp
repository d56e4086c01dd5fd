#pragma once

#include "core/base/diagnostic.hpp"

namespace forefront {

/// Exit codes of the batch commands.
enum ExitCode : int {
    kDone = 0,
    kRefused = 1, ///< the input is refused: faults on stderr, one a line
    kUsage = 2,   ///< wrong usage
    kCancelled = 3
};

/// Prints each fault on a line of stderr.
void printFaults(const Diagnostics &faults);

} // namespace forefront
