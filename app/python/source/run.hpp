#pragma once

#include <pybind11/pybind11.h>

namespace forefront::python {

/// Adds the stepping of a run, and its page, film and trace, to the module.
void bindRun(pybind11::module_ &module);

} // namespace forefront::python
