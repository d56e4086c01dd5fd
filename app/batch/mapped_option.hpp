#pragma once

#include "app/batch/cli_options.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesher/options.hpp"

#include <string>
#include <vector>

namespace forefront {

/// Adds the option --mapped. `texts`: its values.
void addMappedOption(CLI::App &app, std::vector<std::string> &texts);

/// Gives a job the mapped regions of the command line, such as "plate" or "plate:0,0;4,0;4,1;0,1"; those of a project
/// with the same region are replaced. A name may also be a default name such as region_2. Errors: "bad-option",
/// "unknown-region", with the list of regions.
Diagnostics applyMapped(const std::vector<std::string> &texts, MeshingJob &job);

} // namespace forefront
