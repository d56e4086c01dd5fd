#pragma once

#include "app/batch/command_line.hpp"
#include "app/batch/option_table.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// Each of these runs the command `forefront NAME ...` and returns the exit code.
int meshCommand(const CommandLine &line);
int checkCommand(const CommandLine &line);
int adaptCommand(const CommandLine &line);
int convertCommand(const CommandLine &line);
int infoCommand(const CommandLine &line);
int formatsCommand(const CommandLine &line);
int filmCommand(const CommandLine &line);
int tablesCommand(const CommandLine &line);
int rulesCommand(const CommandLine &line);
int traceCommand(const CommandLine &line);
int lessonCommand(const CommandLine &line);
int runCommand(const CommandLine &line);
int completionCommand(const CommandLine &line);
int helpCommand(const CommandLine &line);

/// A command by its name.
struct NamedCommand {
    std::string_view name;
    int (*run)(const CommandLine &) = nullptr;
};
/// Returns the batch commands in the order of the help text.
std::span<const NamedCommand> batchCommands();
/// Returns the batch command of this name; null if there is none.
const NamedCommand *batchCommand(std::string_view name);
/// Describes all batch commands.
std::vector<CommandInfo> describeCommands();
/// Returns the usage error for a word that is no command; `expected` ends the list of what was expected.
std::string unknownCommandText(std::string_view word, std::string_view expected);

/// Returns the help text of the program.
std::string_view usageText();

} // namespace forefront
