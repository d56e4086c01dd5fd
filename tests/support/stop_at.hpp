#pragma once

#include "core/engine/base/progress.hpp"

#include <stop_token>
#include <string_view>

namespace forefront::testing {

/// A progress that cancels at the report of that number, from 1 on; 0: from the start.
class StopAt {
  public:
    explicit StopAt(int report) : left_(report) {
        progress_.stop = stop_.get_token();
        progress_.report = [this](std::string_view, double) { count(); };
        if (report == 0) {
            stop_.request_stop();
        }
    }
    StopAt(const StopAt &) = delete;
    StopAt &operator=(const StopAt &) = delete;

    const Progress &progress() const { return progress_; }

  private:
    void count() {
        if (--left_ == 0) {
            stop_.request_stop();
        }
    }

    std::stop_source stop_;
    Progress progress_;
    int left_;
};

} // namespace forefront::testing
