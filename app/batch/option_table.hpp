#pragma once

#include <CLI/CLI.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// An option or a positional argument of a command, as its help describes it.
struct OptionInfo {
    std::vector<std::string> names; ///< such as "-o" and "--output"; of a positional argument: its word
    std::string value;              ///< word for the value, such as "OUT"; empty for a flag
    std::string help;
    std::vector<std::string> words;    ///< values to offer
    std::vector<std::string> excluded; ///< long names of options that cannot be given with it
    bool positional = false;
    bool required = false;
    bool repeats = false; ///< may be given several times
    bool isPath = false;  ///< the value names a file

    bool isFlag() const { return value.empty() && !positional; }
};

/// A command with its options, as its help describes them.
struct CommandInfo {
    std::string name; ///< such as "forefront mesh"
    std::string description, footer;
    std::vector<OptionInfo> options; ///< in the order of the help

    /// Returns the option with a name such as "--size"; null if there is none.
    const OptionInfo *find(std::string_view name) const;
};

/// Describes a command by the table of options that it is parsed with.
CommandInfo describeCommand(CLI::App &app);

/// Returns a validator that accepts any value, and whose words are offered by completion.
CLI::Validator offering(std::span<const std::string_view> words);
/// The same for words with commas between them.
CLI::Validator offering(std::string_view words);
/// Makes the words of a validator known to describeCommand(). Does not change what it accepts.
CLI::Validator withWords(CLI::Validator validator, std::span<const std::string_view> words);

} // namespace forefront
