#pragma once

#include "app/python/source/mesh.hpp"

namespace forefront::python {

/// Adds what writes meshes, and the elevations that files get.
void bindWriting(py::class_<PythonMesh> &mesh);

} // namespace forefront::python
