#pragma once

#include "app/python/source/domain.hpp"
#include "core/engine/mesh/limits.hpp"
#include "core/engine/mesher/options.hpp"

#include <map>
#include <pybind11/pybind11.h>
#include <string>

namespace forefront::python {

/// Adds the classes Sizes and Options to the module.
void bindJob(py::module_ &module);

/// Returns the job of a domain. `sizes`: sizes of places that are added to those of the domain, and rules, which with
/// `replaces` take the place of the domain's, see SpacingSpec::replaceRules(). The options of a project hold where
/// `options` leaves them unset.
MeshingJob jobOf(const PythonDomain &domain, const SpacingSpec &sizes, bool replaces, const MeshingOptions &options);

/// Returns limits given by their words, such as "max-growth". Raises ValueError, which begins with `what`, for an
/// unknown word or a value beyond its bounds.
MeshLimits limitsOf(const char *what, const std::map<std::string, double> &given);

} // namespace forefront::python
