#pragma once

#include "app/batch/inputs.hpp"
#include "core/base/diagnostic.hpp"
#include "core/domain/domain.hpp"

#include <string_view>

namespace forefront {

/// Exit codes of the batch commands.
enum ExitCode : int {
    kDone = 0,
    kRefused = 1, ///< the input is refused: faults on stderr, one per line
    kUsage = 2,   ///< wrong usage
    kCancelled = 3
};

/// Prints faults to stderr, one per line.
void printFaults(const Diagnostics &faults);

/// Returns true if one of the faults has that code.
bool hasCode(const Diagnostics &faults, std::string_view code);

/// Returns the reasons why a domain was not meshed, or a mesh does not fit it: the domain's own faults if it has any,
/// with the name of its file and, where the domain is `asRead`, their places in it; else `faults`.
Diagnostics meshingFaults(const Diagnostics &faults, const Domain &domain, const Input &input, bool asRead);

} // namespace forefront
