#include "app/batch/cli_options.hpp"
#include "app/batch/commands.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/manual_page.hpp"
#include "app/batch/outputs.hpp"

#include <string>
#include <vector>

namespace forefront {

int helpCommand(const CommandLine &line) {
    std::string command;
    bool man = false;
    CLI::App app("Prints the help of a command, or the manual page.", "forefront help");
    app.footer("\nExit codes: 0 done, 1 cannot write, 2 usage error.");
    std::vector<std::string_view> names;
    for (const NamedCommand &each : batchCommands()) {
        names.push_back(each.name);
    }
    auto *const named = app.add_option("COMMAND", command, "command, such as mesh; default: help of the program")
                            ->check(offering(names));
    app.add_flag("--man", man, "print the manual page forefront(1), to read with man -l or to install")
        ->excludes(named);
    if (const auto code = parseOptions(app, line)) {
        return *code;
    }
    if (!command.empty()) {
        const NamedCommand *const found = batchCommand(command);
        const char *const words[] = {command.c_str(), "--help"};
        return found != nullptr ? found->run({2, words})
                                : wrongUsage(app.get_name(), "unknown command " + unknownCommandText(command, ""));
    }
    const Status printed = printText(man ? manualPage(usageText(), describeCommands()) : std::string(usageText()));
    printFaults(printed);
    return printed.empty() ? kDone : kRefused;
}

} // namespace forefront
