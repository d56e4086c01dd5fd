#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/result.hpp"

#include <pybind11/pybind11.h>
#include <utility>

namespace forefront::python {

namespace py = pybind11;

/// Adds the class Fault to the module.
void bindFaults(py::module_ &module);

/// Returns faults as a list of Fault.
py::list faultList(const Diagnostics &faults);

/// Raises MeshError with faults. The caller holds the GIL.
[[noreturn]] void raiseFaults(const Diagnostics &faults);

/// Raises MeshError if faults hold an error.
inline void raiseErrors(const Diagnostics &faults) {
    if (hasErrors(faults)) {
        raiseFaults(faults);
    }
}

/// Returns the value of a result, or raises MeshError with its faults.
template <class T>
T valueOrRaise(Result<T> result) {
    if (!result) {
        raiseFaults(result.faults());
    }
    return std::move(*result);
}

} // namespace forefront::python
