#include "app/batch/progress_bar.hpp"

#include "core/engine/platform/file_handle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace forefront {

ProgressBar::ProgressBar(bool enabled) : active_(enabled && errorsGoToTerminal()) {}

Progress ProgressBar::progress(std::stop_token stop) {
    return {.report = [this](std::string_view stage, double fraction) { show(stage, fraction); },
            .stop = std::move(stop)};
}

void ProgressBar::show(std::string_view stage, double fraction) {
    using namespace std::chrono_literals;
    const auto now = std::chrono::steady_clock::now();
    if (!active_ || (shown_ && stage == stage_ && now - last_ < 80ms)) {
        return;
    }
    constexpr int kWidth = 30;
    const double part = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 0.0;
    const auto filled = static_cast<int>(part * kWidth);
    const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                            std::string(static_cast<std::size_t>(kWidth - filled), '.');
    std::fprintf(stderr, "\r\x1b[K[%s] %3d %% %.*s", bar.c_str(), static_cast<int>(100.0 * part),
                 static_cast<int>(stage.size()), stage.data());
    std::fflush(stderr);
    stage_ = stage;
    last_ = now;
    shown_ = true;
}

void ProgressBar::clear() {
    if (shown_) {
        std::fputs("\r\x1b[K", stderr);
        std::fflush(stderr);
        shown_ = false;
    }
}

} // namespace forefront
