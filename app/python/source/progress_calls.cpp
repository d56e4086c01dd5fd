#include "app/python/source/progress_calls.hpp"

#include "app/python/source/shared_object.hpp"

#include <chrono>
#include <memory>
#include <string>

namespace forefront::python {

namespace {

constexpr std::chrono::milliseconds kInterval{20};

/// The calls of one operation.
struct ProgressCalls {
    SharedObject callback; ///< null: none
    std::chrono::steady_clock::time_point next = std::chrono::steady_clock::now();
    std::string stage;

    void report(std::string_view current, double fraction) {
        const auto now = std::chrono::steady_clock::now();
        if (now < next && current == stage && fraction < 1.0) {
            return;
        }
        next = now + kInterval;
        stage = current;
        const py::gil_scoped_acquire gil;
        if (PyErr_CheckSignals() != 0) {
            throw py::error_already_set();
        }
        if (callback) {
            (*callback)(stage, fraction);
        }
    }
};

} // namespace

Progress progressOf(const py::object &callback) {
    if (!callback.is_none() && PyCallable_Check(callback.ptr()) == 0) {
        throw py::type_error("progress: expected a function of (stage, fraction)");
    }
    auto calls = std::make_shared<ProgressCalls>();
    calls->callback = callback.is_none() ? nullptr : sharedObject(callback);
    Progress progress;
    progress.report = [calls](std::string_view stage, double fraction) { calls->report(stage, fraction); };
    return progress;
}

} // namespace forefront::python
