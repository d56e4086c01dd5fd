#pragma once

#include <chrono>

namespace forefront {

/// Returns seconds of a clock that never jumps. Unlike Platform::now(), it measures real time in tests too.
inline double steadySeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace forefront
