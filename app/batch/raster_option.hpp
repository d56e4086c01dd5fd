#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// Adds --raster to a command, and --size-preset to the group of its options for the spacing.
void addRasterOptions(CLI::App &app, CLI::App &group, std::vector<std::string> &rasters,
                      std::vector<std::string> &presets);

/// Returns the error in the names of --raster, or in --size-preset, which also sets `expression`; empty if all are
/// valid.
std::string checkRasters(const std::vector<std::string> &rasters, const std::vector<std::string> &presets,
                         std::optional<std::string> &expression);

/// Reads the files of --raster and adds them to a spacing; prints the notes of the files. A raster takes the place of
/// one with the same name. `projection`: see ImportOptions.
Diagnostics addRasters(const std::vector<std::string> &rasters, const std::string &projection, const MapSystem &map,
                       bool quiet, SpacingSpec &spacing);

} // namespace forefront
