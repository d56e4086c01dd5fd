#pragma once

#include <thread>

namespace forefront {

/// Returns the CPU time of another thread so far, in seconds; 0 if the system does not tell.
double cpuSecondsOf(std::jthread &thread);

} // namespace forefront
