#pragma once

#include "core/engine/base/diagnostic.hpp"

#include <filesystem>

namespace forefront {

/// Sets the file of faults that do not name one.
inline Diagnostics named(Diagnostics faults, const std::filesystem::path &path) {
    for (Diagnostic &fault : faults) {
        if (fault.file.empty()) {
            fault.file = path.string();
        }
    }
    return faults;
}

} // namespace forefront
