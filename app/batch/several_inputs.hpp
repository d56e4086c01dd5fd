#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace forefront {

/// Returns a path in which each "{}" is replaced by the name of the input without its extension.
std::filesystem::path withStem(const std::filesystem::path &pattern, const std::filesystem::path &input);

/// Returns the usage error in the names of the files that a command writes for each of its inputs: with several inputs,
/// each name needs "{}"; standard input has no name to put there. Empty if all are valid.
std::string checkStems(const std::vector<std::filesystem::path> &inputs,
                       const std::vector<std::filesystem::path> &outputs);

/// Runs a command once for each input, in order, until one is cancelled. With several inputs, prints the name of each
/// before its results unless `quiet`, and at the end those that were refused. `run` takes the index of the input.
/// Returns the exit code of the worst.
int runEach(const std::vector<std::filesystem::path> &inputs, bool quiet, const std::function<int(std::size_t)> &run);

} // namespace forefront
