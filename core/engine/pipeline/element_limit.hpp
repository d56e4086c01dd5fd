#pragma once

#include "core/engine/pipeline/pipeline.hpp"

#include <cstdint>
#include <string>

namespace forefront {

/// Returns the limit on the elements of a job.
std::uint64_t limitOf(const MeshingOptions &options);

/// Returns the error "too-many-elements" for a job that needs too many elements, with a size that would fit. `what`:
/// the finding, with the number of elements.
Diagnostics tooManyElements(const std::string &what, double needed, double limit, const PreparedJob &prepared);

} // namespace forefront
