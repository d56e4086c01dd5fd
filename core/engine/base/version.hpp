#pragma once

#include "core/engine/base/api.hpp"

namespace FOREFRONT_API forefront {

/// Returns the version of the library, "MAJOR.MINOR.PATCH".
const char *version();

} // namespace forefront
