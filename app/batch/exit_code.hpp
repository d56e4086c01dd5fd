#pragma once

#include "core/base/diagnostic.hpp"
#include "core/domain/domain.hpp"

#include <filesystem>
#include <string_view>

namespace forefront {

/// Exit codes of the batch commands.
enum ExitCode : int {
    kDone = 0,
    kRefused = 1, ///< the input is refused: faults on stderr, one a line
    kUsage = 2,   ///< wrong usage
    kCancelled = 3
};

/// Prints each fault on a line of stderr.
void printFaults(const Diagnostics &faults);

bool hasCode(const Diagnostics &faults, std::string_view code);

/// Why a domain was not meshed, or a mesh does not fit it: its own faults if it has any, with the name of its file and,
/// where the domain is as it was read, their places in it; else `faults`.
Diagnostics meshingFaults(const Diagnostics &faults, const Domain &domain, const std::filesystem::path &file,
                          bool asRead);

} // namespace forefront
