#pragma once

#include "app/batch/option_table.hpp"
#include "core/engine/base/result.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// The options of a command in a file.
struct ConfigOptions {
    std::vector<std::string> words;            ///< such as "--size=0.5", for the command line
    std::map<std::string, std::string> places; ///< "FILE:LINE" by long name such as "--size"
};

/// Returns the options of a TOML file for a command: keys are the long names without dashes, flags are true or false,
/// options that can be repeated take arrays, and `set` is a table of expressions by the names of parameters. A table
/// that is named as a command of `commands` holds options of this command alone, which replace those before all tables.
/// Relative paths are relative to the file. Leaves out options that are `given` on the command line, by their long
/// names, or that exclude one of these. Faults: cannot-read, toml-syntax, unknown-option, bad-value.
Result<ConfigOptions> readConfig(const std::filesystem::path &file, const CommandInfo &command,
                                 const std::vector<std::string_view> &commands, const std::vector<std::string> &given);

} // namespace forefront
