#pragma once

#include <pybind11/pybind11.h>

namespace forefront::python {

/// Adds the readers of domains and meshes, and the list of formats, to the module.
void bindReading(pybind11::module_ &module);

} // namespace forefront::python
