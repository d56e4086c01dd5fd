#pragma once

#include "core/engine/base/progress.hpp"

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

} // namespace forefront::python
