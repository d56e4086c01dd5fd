#pragma once

#include "app/batch/cli_options.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesher/options.hpp"

#include <filesystem>
#include <optional>

namespace forefront {

/// Adds --rules, the rules of the classic method.
void addRulesOption(CLI::App &app, std::optional<std::filesystem::path> &file);

/// Replaces the rules by those of the file that was given, if any. The other options must be final: a method without
/// these rules is an error, and so are the faults of the file.
Diagnostics applyRules(const std::optional<std::filesystem::path> &file, MeshingOptions &options);

} // namespace forefront
