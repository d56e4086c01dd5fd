#pragma once

#include "core/engine/base/progress.hpp"

#include <chrono>
#include <stop_token>
#include <string>
#include <string_view>

namespace forefront {

/// Shows the stage and the fraction done as a progress line on stderr while an operation runs; prints nothing if stderr
/// is not a terminal.
class ProgressBar {
  public:
    /// Prints nothing, even on a terminal, unless `enabled`.
    explicit ProgressBar(bool enabled);
    ~ProgressBar() { clear(); }
    ProgressBar(const ProgressBar &) = delete;
    ProgressBar &operator=(const ProgressBar &) = delete;

    /// Runs an operation that reports to progress(), returns its result, and clears the line afterwards, even after an
    /// exception. `stage`: shown at the start; empty: the operation names its stages.
    template <class Operation>
    auto during(std::string_view stage, Operation operation) {
        const Clearing atEnd{*this};
        if (!stage.empty()) {
            show(stage, 0.0);
        }
        return operation();
    }
    /// Returns a progress that the line shows, with a stop token. It must not outlive this.
    Progress progress(std::stop_token stop);
    /// Clears the line before something is printed in the middle of an operation.
    void clear();

  private:
    struct Clearing {
        ProgressBar &bar;
        ~Clearing() { bar.clear(); }
    };

    void show(std::string_view stage, double fraction);

    bool active_;
    bool shown_ = false;
    std::string stage_;
    std::chrono::steady_clock::time_point last_{};
};

} // namespace forefront
