#include "core/engine/platform/thread_clock.hpp"

#include <ctime>
#include <pthread.h>

#ifdef _WIN32
#include <windows.h>
#endif

namespace forefront {

double cpuSecondsOf(std::jthread &thread) {
#if defined(_WIN32)
    FILETIME created{}, ended{}, kernel{}, user{};
    auto *const handle = static_cast<HANDLE>(pthread_gethandle(thread.native_handle()));
    if (GetThreadTimes(handle, &created, &ended, &kernel, &user) == 0) {
        return 0.0;
    }
    const auto seconds = [](const FILETIME &time) { // in steps of 100 ns
        return 1e-7 *
               (4294967296.0 * static_cast<double>(time.dwHighDateTime) + static_cast<double>(time.dwLowDateTime));
    };
    return seconds(kernel) + seconds(user);
#elif defined(__APPLE__)
    static_cast<void>(thread); // knows no clocks of other threads
    return 0.0;
#else
    clockid_t clock{};
    timespec time{};
    return pthread_getcpuclockid(thread.native_handle(), &clock) == 0 && clock_gettime(clock, &time) == 0
               ? static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec)
               : 0.0;
#endif
}

} // namespace forefront
