#include "ui/background/background_task.hpp"

#include <string_view>
#include <utility>

namespace forefront {

BackgroundTask::BackgroundTask(BackgroundList &list) : worker_(list, answer, {}, LeavableThread::kPatience) {}

BackgroundTask::State BackgroundTask::answer(const LatestTurn<Request, State> &turn) {
    State state{.name = turn.request.purpose};
    Progress progress;
    progress.stop = turn.stop;
    progress.report = [&state, &turn](std::string_view stage, double fraction) {
        constexpr double kStep = 0.02; // a frame for each report would cost more than the work
        if (state.name != stage || fraction >= state.fraction + kStep) {
            state.name = stage;
            state.fraction = fraction;
            turn.publish(state);
        }
    };
    state.result = turn.request.work(progress);
    return state;
}

void BackgroundTask::start(std::string purpose, Work work) {
    purpose_ = std::move(purpose);
    worker_.clear({.name = purpose_});
    busy_ = true;
    worker_.submit({purpose_, std::move(work)});
}

void BackgroundTask::cancel() {
    worker_.clear();
    busy_ = false;
}

void BackgroundTask::finish() {
    const Finish result = worker_.now().result.value_or(Finish());
    cancel(); // the result may start another task
    if (result) {
        result();
    }
}

} // namespace forefront
