#pragma once

#include "core/engine/mesh/limits.hpp"

#include <CLI/CLI.hpp>

namespace forefront {

/// Adds --limit, which can be repeated, and --fix.
void addFixOptions(CLI::App &app, MeshLimits &limits, bool &fix);

} // namespace forefront
