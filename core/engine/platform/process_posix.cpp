#ifndef _WIN32

#include "core/engine/platform/process.hpp"

#include <cerrno>
#include <csignal>
#include <sys/resource.h>
#include <sys/types.h>
#include <unistd.h>

namespace forefront {

long processNumber() {
    return ::getpid();
}

long userNumber() {
    return static_cast<long>(::getuid());
}

bool processIsGone(long number) {
    return ::kill(static_cast<pid_t>(number), 0) != 0 && errno == ESRCH;
}

std::uint64_t peakMemory() {
#ifdef __APPLE__
    constexpr std::uint64_t kUnit = 1;
#else
    constexpr std::uint64_t kUnit = 1024;
#endif
    rusage usage{};
    return ::getrusage(RUSAGE_SELF, &usage) == 0 ? static_cast<std::uint64_t>(usage.ru_maxrss) * kUnit : 0U;
}

} // namespace forefront

#endif
