#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace forefront {

/// Shows the stage and the fraction done as a progress line on stderr; prints nothing if stderr is not a terminal.
class ProgressBar {
  public:
    /// Prints nothing, even on a terminal, unless `enabled`.
    explicit ProgressBar(bool enabled);
    ~ProgressBar() { clear(); }
    ProgressBar(const ProgressBar &) = delete;
    ProgressBar &operator=(const ProgressBar &) = delete;

    void show(std::string_view stage, double fraction);
    void clear();

  private:
    bool active_;
    bool shown_ = false;
    std::string stage_;
    std::chrono::steady_clock::time_point last_{};
};

} // namespace forefront
