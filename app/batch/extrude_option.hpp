#pragma once

#include "app/batch/outputs.hpp"
#include "core/engine/mesher/options.hpp"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// Adds --extrude.
void addExtrudeOption(CLI::App &app, MeshForm &form);

/// Returns the error for outputs that cannot hold an extruded mesh, also of elements of second order if `order` asks
/// for them; empty if there is none.
std::string checkExtrude(const MeshForm &form, const std::vector<Output> &outputs, std::optional<ElementOrder> order);

} // namespace forefront
