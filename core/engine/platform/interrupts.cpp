#include "core/engine/platform/interrupts.hpp"

#ifdef _WIN32
#include <windows.h>
#else
#include <ctime>
#endif

namespace forefront {

#ifdef _WIN32

namespace {

/// Set by the system's thread, which knows no objects of ours.
HANDLE interruptEvent() {
    static const HANDLE event = CreateEventW(nullptr, FALSE, FALSE, nullptr);
    return event;
}

BOOL WINAPI onConsoleEvent(DWORD kind) {
    if (kind != CTRL_C_EVENT && kind != CTRL_BREAK_EVENT) {
        return FALSE;
    }
    SetEvent(interruptEvent());
    return TRUE;
}

} // namespace

InterruptEvents::InterruptEvents() {
    ResetEvent(interruptEvent());
    SetConsoleCtrlHandler(onConsoleEvent, TRUE);
}

InterruptEvents::~InterruptEvents() {
    SetConsoleCtrlHandler(onConsoleEvent, FALSE);
}

bool InterruptEvents::wait(std::chrono::milliseconds time) {
    return WaitForSingleObject(interruptEvent(), static_cast<DWORD>(time.count())) == WAIT_OBJECT_0;
}

#else

InterruptEvents::InterruptEvents() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    sigaddset(&signals_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals_, &before_);
}

InterruptEvents::~InterruptEvents() {
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

bool InterruptEvents::wait(std::chrono::milliseconds time) {
    constexpr long kPerSecond = 1'000, kNanoseconds = 1'000'000;
    const timespec limit{static_cast<std::time_t>(time.count() / kPerSecond),
                         static_cast<long>(time.count() % kPerSecond) * kNanoseconds};
    return sigtimedwait(&signals_, nullptr, &limit) > 0;
}

#endif

} // namespace forefront
