#pragma once

#include "app/python/source/domain.hpp"
#include "core/engine/mesher/options.hpp"

#include <pybind11/pybind11.h>

namespace forefront::python {

/// Adds the classes Sizes and Options to the module.
void bindJob(py::module_ &module);

/// Returns the job of a domain. `sizes`: rules that replace those of the domain, see SpacingSpec::replaceRules(), or
/// null; sizes of places of `sizes` are added. The options of a project hold where `options` leaves them unset.
MeshingJob jobOf(const PythonDomain &domain, const SpacingSpec &sizes, bool replaces, const MeshingOptions &options);

} // namespace forefront::python
