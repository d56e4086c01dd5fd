#include "app/batch/interrupt.hpp"

#include "app/batch/exit_code.hpp"
#include "core/engine/platform/file_handle.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace forefront {

InterruptWatch::InterruptWatch() {
    using namespace std::chrono_literals;
    watcher_ = std::jthread([this](const std::stop_token &stop) {
        while (!stop.stop_requested()) {
            if (!events_.wait(20ms)) {
                continue;
            }
            if (!defers_) {
                std::fputs(errorsGoToTerminal() ? "\r\x1b[Kcancelled\n" : "cancelled\n", stderr);
                std::_Exit(kCancelled);
            }
            cancel_.request_stop();
        }
    });
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
