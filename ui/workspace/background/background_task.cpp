#include "ui/workspace/background/background_task.hpp"

#include <stop_token>
#include <string_view>
#include <utility>

namespace forefront {

BackgroundTask::BackgroundTask(std::function<void()> wake) : wake_(std::move(wake)) {}

void BackgroundTask::start(std::string purpose, Work work) {
    cancel();
    purpose_ = std::move(purpose);
    now_ = {.name = purpose_};
    worker_.start(now_, wake_, [work = std::move(work)](WorkerState<State> &worker, const std::stop_token &stop) {
        Progress progress;
        progress.stop = stop;
        progress.report = [&worker](std::string_view stage, double fraction) {
            worker.change([&](State &state) {
                constexpr double kStep = 0.02; // a frame for each report would cost more than the work
                if (state.name == stage && fraction < state.fraction + kStep) {
                    return false;
                }
                state.name = stage;
                state.fraction = fraction;
                return true;
            });
        };
        Finish result = work(progress);
        worker.change([&](State &state) {
            state.result = std::move(result);
            return true;
        });
    });
}

void BackgroundTask::cancel() {
    worker_.retire();
    now_.result.reset();
}

bool BackgroundTask::refresh() {
    std::optional<State> newest = worker_.refresh();
    if (newest) {
        now_ = std::move(*newest);
    }
    return newest.has_value();
}

void BackgroundTask::finish() {
    const Finish result = now_.result ? *now_.result : Finish();
    cancel(); // the result may start another task
    if (result) {
        result();
    }
}

} // namespace forefront
