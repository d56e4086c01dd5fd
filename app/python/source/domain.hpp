#pragma once

#include "core/engine/mesher/options.hpp"
#include "core/files/common/domain_file.hpp"

#include <pybind11/pybind11.h>

namespace forefront::python {

namespace py = pybind11;

/// A domain with the element sizes that belong to it, and the meshing options of the project that it was read from.
struct PythonDomain {
    Domain domain;
    SpacingSpec spacing;
    MeshingOptions options;
};

/// Adds the base class of forefront.Domain to the module.
void bindDomain(py::module_ &module);

} // namespace forefront::python
