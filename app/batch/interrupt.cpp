#include "app/batch/interrupt.hpp"

#include <ctime>

namespace forefront {

InterruptWatch::InterruptWatch() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals, &before_);
    watcher_ = std::jthread([this, signals](const std::stop_token &leave) {
        while (!leave.stop_requested()) {
            const timespec patience{0, 20'000'000};
            if (sigtimedwait(&signals, nullptr, &patience) > 0) {
                cancel_.request_stop();
            }
        }
    });
}

InterruptWatch::~InterruptWatch() {
    watcher_.request_stop();
    watcher_.join();
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

} // namespace forefront
