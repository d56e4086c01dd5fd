#pragma once

#include "app/batch/cli_options.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/domain/domain.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace forefront {

/// Adds the option --crack. `names`: its values.
void addCrackOption(CLI::App &app, std::vector<std::string> &names);

/// Adds the cracks of the command line to those of the input. A name may also be a default name such as boundary_2.
/// Error: "unknown-boundary", with the list of parts.
Diagnostics applyCracks(const std::vector<std::string> &names, const Domain &domain, std::vector<std::int32_t> &cracks);

} // namespace forefront
