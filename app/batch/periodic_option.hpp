#pragma once

#include "app/batch/cli_options.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesher/options.hpp"

#include <string>
#include <vector>

namespace forefront {

/// Adds the option --periodic. `texts`: its values.
void addPeriodicOption(CLI::App &app, std::vector<std::string> &texts);

/// Gives a job the periodic parts of the command line, such as "left:right"; pairs of a project with the same parts are
/// replaced. A name may also be a default name such as boundary_2. Errors: "bad-option", "unknown-boundary", with the
/// list of parts.
Diagnostics applyPeriodic(const std::vector<std::string> &texts, MeshingJob &job);

} // namespace forefront
