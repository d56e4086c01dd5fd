#pragma once

#include "core/engine/mesher/options.hpp"
#include "core/files/common/domain_file.hpp"

#include <cstdint>
#include <pybind11/pybind11.h>
#include <vector>

namespace forefront::python {

namespace py = pybind11;

/// A domain with the element sizes that belong to it, and the meshing options of the project that it was read from.
struct PythonDomain {
    Domain domain;
    SpacingSpec spacing;
    MeshingOptions options;
    std::vector<std::int32_t> cracks{};   ///< see MeshingJob::cracks
    std::vector<PeriodicSpec> periodic{}; ///< see MeshingJob::periodic
    std::vector<MappedSpec> mapped{};     ///< see MeshingJob::mapped
    bool fromMesh = false;                ///< nobody asked for `periodic`: a mesh file shows it
};

/// Adds the base class of forefront.Domain to the module.
void bindDomain(py::module_ &module);

} // namespace forefront::python
