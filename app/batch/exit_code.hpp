#pragma once

#include "app/batch/inputs.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/domain/domain.hpp"

namespace forefront {

struct Repaired;

/// Exit codes of the batch commands.
enum ExitCode : int {
    kDone = 0,
    kRefused = 1,  ///< the input is refused: faults on stderr, one per line
    kUsage = 2,    ///< usage error
    kCancelled = 3 ///< 4 is kNoWindow, an exit code of the editor
};

/// Prints faults to stderr, one per line. Advice to repair the domain also names the command-line options for that.
void printFaults(const Diagnostics &faults);

/// Returns why a domain was not meshed, or why a mesh does not fit it: the domain's own faults if it has any, with the
/// name of its file and their positions in it; otherwise `faults`. `repaired` is the repair that produced the domain,
/// or null if the domain is as read.
Diagnostics meshingFaults(const Diagnostics &faults, const Domain &domain, const Input &input,
                          const Repaired *repaired);
/// Adds the name of the domain's file, and the positions of the parts in it, to faults that refer to parts of a domain;
/// other faults are left unchanged.
Diagnostics locateInDomain(Diagnostics faults, const Input &input, const Repaired *repaired);
/// Adds the place of the spacing expression in a project to its faults; other faults are left unchanged.
Diagnostics locateSpacing(Diagnostics faults, const Input &project);

} // namespace forefront
