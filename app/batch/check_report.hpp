#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesh/limits.hpp"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace forefront {

/// Adds an option for each limit, "--min-angle" and so on.
void addLimitOptions(CLI::App &group, MeshLimits &limits);

/// Reads the limits saved in a project, with other expressions for its parameters, and adds those that are not set yet.
/// Returns the faults of the file.
Diagnostics addSavedLimits(const std::filesystem::path &project, const std::map<std::string, std::string> &parameters,
                           MeshLimits &limits);

/// Prints a table of all quality measures of a mesh, with minimum, percentiles, maximum and mean.
void printMeasures(const MeshView &mesh, const SpacingField *spacing);

/// Number of places listed for each violated limit.
inline constexpr std::size_t kListedPlaces = 5;

/// Prints the worst places of the verdicts to stderr and, if `prints`, each verdict to stdout. Returns true if the mesh
/// meets all limits.
bool printVerdicts(const std::filesystem::path &file, const std::vector<LimitVerdict> &verdicts,
                   const MeshNumbers &numbers, bool prints);

} // namespace forefront
