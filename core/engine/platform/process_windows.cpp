#ifdef _WIN32

#include "core/engine/platform/process.hpp"

#include <windows.h>
// After windows.h, which it needs.
#include <psapi.h>

namespace forefront {

long processNumber() {
    return static_cast<long>(GetCurrentProcessId());
}

long userNumber() {
    return 0;
}

bool processIsGone(long number) {
    void *const process = OpenProcess(SYNCHRONIZE, FALSE, static_cast<DWORD>(number));
    if (process == nullptr) {
        return GetLastError() == ERROR_INVALID_PARAMETER;
    }
    const bool ended = WaitForSingleObject(process, 0) == WAIT_OBJECT_0;
    CloseHandle(process);
    return ended;
}

std::uint64_t peakMemory() {
    PROCESS_MEMORY_COUNTERS counters{};
    return K32GetProcessMemoryInfo(GetCurrentProcess(), &counters, sizeof counters) != 0 ? counters.PeakWorkingSetSize
                                                                                         : 0U;
}

} // namespace forefront

#endif
