#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/length_unit.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/files/common/domain_file.hpp"
#include "core/files/source/map_system.hpp"

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
    Diagnostics notes{};                  ///< of the reader and of repairs
    LengthUnit unit = LengthUnit::None;   ///< of the coordinates, if the file names one
    MapSystem system{};                   ///< of the coordinates of a map
};

/// Adds the base class of forefront.Domain to the module.
void bindDomain(py::module_ &module);

} // namespace forefront::python
