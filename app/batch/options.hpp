#pragma once

#include "core/io/inner_edges.hpp"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// Checks of option values. A fault reads "--size: a positive number is wanted, not 'abc'".
CLI::Validator positiveNumber();
CLI::Validator numberWithin(double least, double greatest);
CLI::Validator wholeNumberWithin(int least, int greatest);
CLI::Validator oneOf(std::vector<std::string> words);

/// The options --size and --spacing, which several commands have.
void addSpacingOptions(CLI::App &group, std::optional<double> &size, std::optional<std::string> &expression);

/// Adds the option --inner-edges of the commands that write meshes.
void addInnerEdgesOption(CLI::App &app, InnerEdges &innerEdges);

/// Parses the command line. The exit code with which to leave (help was shown: 0; wrong usage, said on stderr: 2), or
/// nothing to go on.
std::optional<int> parseOptions(CLI::App &app, int argc, const char *const *argv);

/// Says on stderr what is wrong with the command line of `command` ("forefront mesh") and returns the exit code.
int wrongUsage(const std::string &command, std::string_view message);

} // namespace forefront
