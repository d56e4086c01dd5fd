#pragma once

#include "app/batch/inputs.hpp"
#include "core/base/diagnostic.hpp"
#include "core/domain/domain.hpp"

#include <string_view>

namespace forefront {

struct Repaired;

/// Exit codes of the batch commands.
enum ExitCode : int {
    kDone = 0,
    kRefused = 1,  ///< the input is refused: faults on stderr, one per line
    kUsage = 2,    ///< usage error
    kCancelled = 3 ///< 4 is kNoWindow, an exit code of the editor
};

/// Prints faults to stderr, one per line. Advice to repair the domain names the options for it.
void printFaults(const Diagnostics &faults);

/// Returns true if one of the faults has that code.
bool hasCode(const Diagnostics &faults, std::string_view code);

/// Returns the reasons why a domain was not meshed, or a mesh does not fit it: the domain's own faults if it has any,
/// with the name of its file and their places in it; else `faults`. `repaired`: the repair that gave the domain, or
/// null if it is as read.
Diagnostics meshingFaults(const Diagnostics &faults, const Domain &domain, const Input &input,
                          const Repaired *repaired);
/// Adds the domain's file to faults that concern parts of a domain, and the places of those parts in it; other faults
/// stay as they are.
Diagnostics locateInDomain(Diagnostics faults, const Input &input, const Repaired *repaired);

} // namespace forefront
