#pragma once

#include "core/engine/base/diagnostic.hpp"

#include <string>
#include <string_view>

namespace forefront {

/// Returns the error of a cancelled action: code "cancelled", message "ACTION was cancelled".
inline Diagnostics cancelled(std::string_view action) {
    return error("cancelled", std::string(action) + " was cancelled");
}

} // namespace forefront
