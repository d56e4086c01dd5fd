/// The extension module forefront._core. The package in forefront/ is its only user; it adds the classes, defaults and
/// texts that users see. Nothing here is global: all state is in objects, and every call may come from any thread.
#include "app/python/source/domain.hpp"
#include "app/python/source/faults.hpp"
#include "app/python/source/job.hpp"
#include "app/python/source/mesh.hpp"
#include "app/python/source/meshing.hpp"
#include "app/python/source/reading.hpp"
#include "app/python/source/run.hpp"
#include "core/engine/base/version.hpp"

#include <pybind11/pybind11.h>

PYBIND11_MODULE(_core, module) {
    module.doc() = "The compiled part of forefront.";
    module.attr("__version__") = forefront::version();
    forefront::python::bindFaults(module);
    forefront::python::bindDomain(module);
    forefront::python::bindJob(module);
    forefront::python::bindMesh(module);
    forefront::python::bindMeshing(module);
    forefront::python::bindReading(module);
    forefront::python::bindRun(module);
}
