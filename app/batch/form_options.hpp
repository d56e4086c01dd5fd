#pragma once

#include "app/batch/outputs.hpp"
#include "core/engine/mesh/second_order.hpp"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// Adds the options that say how a mesh is written: --open, --extrude, --tags, --unit and --elevation. `unit` says in
/// the help which unit is written without --unit.
void addFormOptions(CLI::App &app, MeshForm &form, const std::string &unit);

/// Opens the boundary parts of a project, and gives the nodes its elevation, where the options do not say otherwise and
/// an output holds elevations.
void useWaterOf(const std::vector<std::int32_t> &openBoundaries, const std::string &elevation,
                const std::vector<Output> &outputs, MeshForm &form);

/// Returns the first error in how a mesh is written: an option that no output has a place for, or one that does not go
/// with another; empty if there is none. `order`: that of the mesh, where it is given.
std::string checkForm(const MeshForm &form, const std::vector<Output> &outputs, std::optional<ElementOrder> order);

} // namespace forefront
