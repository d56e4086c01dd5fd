#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace forefront {

/// A progress line on a terminal (stderr) with the stage and the fraction done; silent elsewhere.
class ProgressBar {
  public:
    /// If not `enabled`, silent even on a terminal.
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
