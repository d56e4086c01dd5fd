#pragma once

#include "core/engine/base/progress.hpp"

#include <exception>
#include <memory>
#include <pybind11/pybind11.h>

namespace forefront::python {

namespace py = pybind11;

/// Returns a progress that lets Python handle signals, so that Ctrl-C cancels, and calls `callback`, which may be None,
/// as callback(stage, fraction). Both happen at most every 20 ms, except where a stage begins or ends. An exception
/// ends the operation and reaches the caller. The operation runs without the GIL; the progress takes it for the calls.
Progress progressOf(const py::object &callback);

/// Runs a function without the GIL and returns its result.
template <class Function>
auto withoutGil(const Function &function) {
    const py::gil_scoped_release release;
    return function();
}

/// A progress that lets Python handle signals every 20 ms. Ctrl-C stops the operation, which must check the stop token
/// and return; raise() then raises what the handler of the signal raised. Unlike progressOf(), nothing is thrown
/// through the operation, so that what it has done so far remains.
class Interruption {
  public:
    Interruption();
    const Progress &progress() const { return progress_; }
    /// Raises what the handler of a signal raised, if one did. The GIL must be held.
    void raise() const;

  private:
    std::shared_ptr<std::exception_ptr> raised_;
    Progress progress_;
};

} // namespace forefront::python
