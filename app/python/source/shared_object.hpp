#pragma once

#include <memory>
#include <pybind11/pybind11.h>

namespace forefront::python {

/// A Python object that C++ may copy and drop without the GIL, on any thread.
using SharedObject = std::shared_ptr<pybind11::object>;

/// Returns a shared reference to an object. The caller holds the GIL.
inline SharedObject sharedObject(pybind11::object object) {
    return {new pybind11::object(std::move(object)), [](pybind11::object *held) {
                const pybind11::gil_scoped_acquire gil;
                delete held;
            }};
}

} // namespace forefront::python
