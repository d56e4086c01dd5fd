#pragma once

#include "core/engine/base/api.hpp"

#include <functional>
#include <stop_token>
#include <string_view>

namespace FOREFRONT_API forefront {

/// Progress callback and stop token of a long operation. Default-constructed: silent and never cancelled.
struct Progress {
    /// Called from the thread that called the operation, with the name of the stage and the fraction done in [0, 1];
    /// may be empty. If it throws, the operation ends and its caller gets the exception.
    std::function<void(std::string_view stage, double fraction)> report;
    /// Checked often enough that cancelling takes less than 100 ms.
    std::stop_token stop;

    void operator()(std::string_view stage, double fraction) const {
        if (report) {
            report(stage, fraction);
        }
    }
    bool cancelled() const { return stop.stop_requested(); }
};

} // namespace forefront
