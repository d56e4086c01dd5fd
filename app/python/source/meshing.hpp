#pragma once

#include <pybind11/pybind11.h>

namespace forefront::python {

/// Adds mesh(), adapt() and the faces of meshes to the module.
void bindMeshing(pybind11::module_ &module);

} // namespace forefront::python
