#pragma once

#include "app/python/source/domain.hpp"
#include "core/engine/mesher/options.hpp"

#include <pybind11/pybind11.h>

namespace forefront::python {

/// Adds the classes Sizes and Options to the module.
void bindJob(py::module_ &module);

/// Returns the job of a domain. `sizes`: sizes of places that are added to those of the domain, and rules, which with
/// `replaces` take the place of the domain's, see SpacingSpec::replaceRules(). The options of a project hold where
/// `options` leaves them unset.
MeshingJob jobOf(const PythonDomain &domain, const SpacingSpec &sizes, bool replaces, const MeshingOptions &options);

} // namespace forefront::python
