#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/mesh/limits.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <string>

namespace forefront {

/// Returns a note that lists the rules of a project, besides its size or expression, that an option such as --size
/// replaces; empty if there are none.
Diagnostics replacedSpacing(const std::string &option, const SpacingSpec &spacing);

/// Returns a warning for each limit that a mesh violates.
Diagnostics violatedLimits(const MeshView &mesh, const MeshLimits &limits, const SpacingField *spacing);

} // namespace forefront
