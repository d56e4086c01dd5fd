#pragma once

#include "app/batch/outputs.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace forefront {

/// Adds --tags.
void addTagsOption(CLI::App &app, MeshForm &form);

/// Returns the error for --tags keep with outputs on which it has no effect; empty if there is none.
std::string checkTags(const MeshForm &form, const std::vector<Output> &outputs);

} // namespace forefront
