#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/length_unit.hpp"
#include "core/engine/domain/part_names.hpp"
#include "core/engine/mesh/limits.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/files/common/domain_file.hpp"
#include "core/files/source/map_system.hpp"

#include <cstdint>
#include <pybind11/pybind11.h>
#include <span>
#include <vector>

namespace forefront::python {

namespace py = pybind11;

/// A domain with the element sizes that belong to it, and the meshing options of the project that it was read from.
struct PythonDomain {
    Domain domain;
    SpacingSpec spacing;
    MeshingOptions options;
    std::vector<std::int32_t> cracks{};           ///< see MeshingJob::cracks
    std::vector<PeriodicSpec> periodic{};         ///< see MeshingJob::periodic
    std::vector<MappedSpec> mapped{};             ///< see MeshingJob::mapped
    std::vector<StripSpec> strips{};              ///< see MeshingJob::strips
    std::vector<LayerSpec> layers{};              ///< see MeshingJob::layers
    std::vector<RegionElements> regionElements{}; ///< see MeshingJob::regionElements
    std::vector<PeriodicSpec> periodicOfMesh{};   ///< of `periodic`: nobody asked for them, a mesh file shows them
    Diagnostics notes{};                          ///< of the reader and of repairs
    LengthUnit unit = LengthUnit::None;           ///< of the coordinates, if the file names one
    MapSystem system{};                           ///< of the coordinates of a map
    MeshLimits limits{};                          ///< of a project
};

/// Returns the tag of a boundary part given by its name, which is added if it is new, or by its number; None: 1.
std::int32_t boundaryTag(Domain &domain, const py::handle &part);
/// Returns the tag of a region given by its name, which is added if it is new, or by its number.
std::int32_t regionTag(Domain &domain, const py::handle &part);

/// Names parts of the boundary and adds a note on each. Raises MeshError as nameParts() fails.
void namePartsOf(std::span<const PartName> parts, PythonDomain &domain);

/// Adds the base class of forefront.Domain to the module.
void bindDomain(py::module_ &module);
/// Adds the methods for layers, cracks, periodic parts, mapped regions, strips and elements of regions.
void bindLinked(py::class_<PythonDomain> &domain);

} // namespace forefront::python
