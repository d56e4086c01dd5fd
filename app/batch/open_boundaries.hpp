#pragma once

#include "app/batch/outputs.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/files/source/export_options.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace forefront {

/// Adds the option --open, which can be repeated.
void addOpenOption(CLI::App &app, MeshForm &form);

/// Returns what is wrong with --open; empty if nothing is. It needs an output whose format tells open boundaries from
/// land.
std::string checkOpen(const MeshForm &form, const std::vector<Output> &outputs);

/// Returns the fault "unknown-boundary" for names of --open that no part of the boundary has, with the names that it
/// has.
Diagnostics checkOpenNames(const MeshForm &form, const Domain &domain);
Diagnostics checkOpenNames(const MeshForm &form, const MeshView &mesh);

/// Returns the options of a file: the tags of the open parts, by --open or, without it, of the project.
ExportOptions exportOptionsOf(const MeshForm &form, const MeshView &mesh);

} // namespace forefront
