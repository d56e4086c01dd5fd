#pragma once

#include "app/batch/outputs.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace forefront {

/// Adds --unit; `fallback` says in the help which unit is written without it.
void addUnitOption(CLI::App &app, MeshForm &form, const std::string &fallback);

/// Returns the error for --unit with outputs that have no place for it; empty if there is none.
std::string checkUnit(const MeshForm &form, const std::vector<Output> &outputs);

/// Returns the form with the unit of the input unless another one is given.
MeshForm withUnitOf(LengthUnit input, MeshForm form);

} // namespace forefront
