#pragma once

#include "app/python/source/mesh.hpp"

namespace forefront::python {

/// Adds what makes a mesh of another one: other elements, other numbers, another spacing to compare with.
void bindDerived(py::class_<PythonMesh> &mesh);

} // namespace forefront::python
