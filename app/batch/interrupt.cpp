#include "app/batch/interrupt.hpp"

#include "app/batch/exit_code.hpp"

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <unistd.h>

namespace forefront {

InterruptWatch::InterruptWatch() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals, &before_);
    watcher_ = std::jthread([this, signals](const std::stop_token &stop) {
        while (!stop.stop_requested()) {
            const timespec pollInterval{0, 20'000'000};
            if (sigtimedwait(&signals, nullptr, &pollInterval) <= 0) {
                continue;
            }
            if (!defers_) {
                std::fputs(isatty(STDERR_FILENO) == 1 ? "\r\x1b[Kcancelled\n" : "cancelled\n", stderr);
                std::_Exit(kCancelled);
            }
            cancel_.request_stop();
        }
    });
}

InterruptWatch::~InterruptWatch() {
    watcher_.request_stop();
    watcher_.join();
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

int refuse(const Diagnostics &faults, const InterruptWatch &interrupt) {
    if (interrupt.interrupted()) {
        std::fputs("cancelled\n", stderr);
        return kCancelled;
    }
    printFaults(faults);
    return kRefused;
}

} // namespace forefront
