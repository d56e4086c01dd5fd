#pragma once

#include <pybind11/pybind11.h>

namespace forefront::python {

/// Adds the stepping of a run, and the page that plays one, to the module.
void bindRun(pybind11::module_ &module);

} // namespace forefront::python
