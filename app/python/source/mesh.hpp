#pragma once

#include "core/engine/base/length_unit.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/mesh/mesh.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/engine/mesher/statistics.hpp"
#include "core/engine/quads/quad_report.hpp"
#include "core/engine/refine/least_angle.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "core/files/source/map_system.hpp"

#include <memory>
#include <optional>
#include <pybind11/pybind11.h>

namespace forefront::python {

namespace py = pybind11;

/// How a mesh was made.
struct MadeBy {
    WorkCounters work;
    QuadReport quads;
    std::optional<double> leastAngle; ///< that was asked for, degrees
    LeastAngleReport angles;
    Elements elements = Elements::Triangles;
    ImproveLevel improve = ImproveLevel::None;
    double secondsPrepare = 0.0, secondsMesh = 0.0, secondsImprove = 0.0; ///< CPU time
    std::uint64_t peakBytes = 0; ///< maximum resident memory of the process when it was done
};

/// An immutable mesh, shared by its Python objects and their arrays, with the spacing that it was made for.
struct PythonMesh {
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const SpacingField> spacing; ///< null: unknown
    std::optional<MadeBy> made;                  ///< nothing for a mesh that was read
    Diagnostics notes{};                         ///< of the reader, then of the run
    LengthUnit unit = LengthUnit::None;          ///< of the coordinates, which files name
    MapSystem system{};                          ///< of the coordinates of a map, which files name
};

/// Wraps a mesh and gives each element a region.
PythonMesh pythonMesh(Mesh mesh);

/// Adds the base class of forefront.Mesh to the module.
void bindMesh(py::module_ &module);
/// Adds what measures, checks and writes meshes.
void bindMeshReports(py::class_<PythonMesh> &mesh);

} // namespace forefront::python
