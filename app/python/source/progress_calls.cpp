#include "app/python/source/progress_calls.hpp"

#include "app/python/source/shared_object.hpp"

#include <chrono>
#include <exception>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

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

Interruption::Interruption() : raised_(std::make_shared<std::exception_ptr>()) {
    std::stop_source source;
    progress_.stop = source.get_token();
    progress_.report = [raised = raised_, source, next = std::chrono::steady_clock::now()](std::string_view,
                                                                                           double) mutable {
        const auto now = std::chrono::steady_clock::now();
        if (now < next || source.stop_requested()) {
            return;
        }
        next = now + kInterval;
        const py::gil_scoped_acquire gil;
        if (PyErr_CheckSignals() != 0) {
            *raised = std::make_exception_ptr(py::error_already_set());
            source.request_stop();
        }
    };
}

void Interruption::raise() const {
    if (*raised_) {
        std::rethrow_exception(*raised_);
    }
}

} // namespace forefront::python
