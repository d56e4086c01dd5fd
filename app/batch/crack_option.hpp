#pragma once

#include "app/batch/cli_options.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/domain/domain.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace forefront {

/// The cracks of the command line.
struct CrackArguments {
    std::vector<std::string> names; ///< values of --crack
    bool dropsOthers = false;       ///< --no-cracks: the cracks of the input are left out

    bool any() const { return dropsOthers || !names.empty(); }
};

/// Adds the options --crack and --no-cracks. `crackHelp`: what --crack does.
void addCrackOptions(CLI::App &app, CrackArguments &arguments, const char *crackHelp);

/// Adds the cracks of the command line to those of the input, or puts them in their place. A name may also be a default
/// name such as boundary_2. Error: "unknown-boundary", with the list of parts.
Diagnostics applyCracks(const CrackArguments &arguments, const Domain &domain, std::vector<std::int32_t> &cracks);

} // namespace forefront
