#include "app/batch/cli_options.hpp"
#include "app/batch/commands.hpp"
#include "app/batch/config_file.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/option_table.hpp"
#include "app/batch/suggestion.hpp"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <vector>

namespace forefront {

namespace {

/// Returns the long names of all options, "--size" and so on.
std::vector<std::string> optionNames(const CLI::App &app) {
    std::vector<std::string> names;
    for (const CLI::Option *option : app.get_options()) {
        for (const std::string &name : option->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    for (const CLI::App *const group : app.get_subcommands([](const CLI::App *) { return true; })) {
        const std::vector<std::string> more = optionNames(*group);
        names.insert(names.end(), more.begin(), more.end());
    }
    return names;
}

/// Lists the arguments that no option or input accepts, in order. A single unknown option gets a suggestion.
std::string unexpectedArguments(const CLI::App &app) {
    const std::vector<std::string> arguments = app.remaining();
    std::string options, others;
    const auto isOption = [](const std::string &argument) { return argument.size() > 1 && argument.front() == '-'; };
    if (std::count_if(arguments.begin(), arguments.end(), isOption) == 1) {
        const std::string &unknown = *std::find_if(arguments.begin(), arguments.end(), isOption);
        const std::vector<std::string> names = optionNames(app);
        return "unknown option '" + unknown + '\'' +
               suggestion(std::string_view(unknown).substr(0, unknown.find('=')),
                          std::vector<std::string_view>(names.begin(), names.end()));
    }
    for (const std::string &argument : arguments) {
        std::string &list = isOption(argument) ? options : others;
        list += (list.empty() ? "'" : ", '") + argument + '\'';
    }
    return options.empty() ? "unexpected argument " + others : "unknown option " + options;
}

/// Returns the names of options as "--size, --spacing".
std::string namesOf(const std::vector<const CLI::Option *> &options) {
    std::string names;
    for (const CLI::Option *option : options) {
        names += (names.empty() ? "" : ", ") + option->get_name();
    }
    return names;
}

/// Describes the first group of options of which too few or too many are given; empty if there is none.
std::string groupFault(const CLI::App &app) {
    for (const CLI::App *const group : app.get_subcommands([](const CLI::App *) { return true; })) {
        const std::vector<const CLI::Option *> all =
            group->get_options([](const CLI::Option *option) { return option->get_name() != "--help"; });
        std::vector<const CLI::Option *> given;
        std::copy_if(all.begin(), all.end(), std::back_inserter(given),
                     [](const CLI::Option *option) { return option->count() > 0; });
        if (given.size() < group->get_require_option_min()) {
            return "missing option; add one of " + namesOf(all);
        }
        if (group->get_require_option_max() > 0 && given.size() > group->get_require_option_max()) {
            return "only one of " + namesOf(all) + " can be given, got " + namesOf(given);
        }
    }
    return {};
}

/// Describes what is wrong with the command line, in our own words where CLI11's are hard to understand.
std::string parseFault(const CLI::App &app, const CLI::ParseError &error) {
    const std::string text = error.what();
    const std::size_t colon = text.find(": ");
    if (error.get_name() == "ArgumentMismatch" && text.ends_with(" missing") && colon != std::string::npos) {
        return text.substr(0, colon) + ": missing value";
    }
    constexpr std::string_view kOnce = "At Most 1 required but received ";
    if (const std::size_t at = text.find(kOnce); at != std::string::npos && colon != std::string::npos) {
        return text.substr(0, colon) + ": given " + text.substr(at + kOnce.size()) + " times; expected once";
    }
    const std::string fault = error.get_name() == "RequiredError" ? groupFault(app) : std::string();
    return fault.empty() ? text : fault;
}

} // namespace

void addConfigOption(CLI::App &app) {
    app.add_option_function<std::string>(
           "--config", [](const std::string &) {}, // parseOptions() reads it before the others
           "TOML file of options: their names without dashes as keys, true for flags; those on the command line take "
           "precedence, and a table such as [mesh] holds those of one command")
        ->type_name("FILE.toml");
}

namespace {

/// Returns the long names of the options on a command line, and the file after --config if there is one.
std::vector<std::string> givenOptions(const CommandLine &line, const CommandInfo &info,
                                      std::optional<std::filesystem::path> &config) {
    std::vector<std::string> given;
    for (int k = 1; k < line.argc && std::string_view(line.argv[k]) != "--"; ++k) {
        const std::string_view word = line.argv[k], name = word.substr(0, word.find('='));
        const OptionInfo *const option = info.find(name.starts_with("--") ? name : name.substr(0, 2));
        if (option == nullptr) {
            continue;
        }
        given.push_back(option->names.back());
        if (name == "--config" && (name.size() < word.size() || k + 1 < line.argc)) {
            config = name.size() < word.size() ? word.substr(name.size() + 1) : std::string_view(line.argv[k + 1]);
        }
    }
    return given;
}

/// Returns the options of the file after --config, or its faults.
Result<ConfigOptions> configOf(CLI::App &app, const CommandLine &line) {
    const CommandInfo info = describeCommand(app);
    std::optional<std::filesystem::path> file;
    const std::vector<std::string> given = givenOptions(line, info, file);
    if (info.find("--config") == nullptr || !file) {
        return ConfigOptions{};
    }
    std::vector<std::string_view> commands;
    for (const NamedCommand &command : batchCommands()) {
        commands.push_back(command.name);
    }
    return readConfig(*file, info, commands, given);
}

} // namespace

std::optional<int> parseOptions(CLI::App &app, const CommandLine &line) {
    if (line.info != nullptr) {
        *line.info = describeCommand(app);
        return 0;
    }
    const Result<ConfigOptions> config = configOf(app, line);
    if (!config) {
        printFaults(config.faults());
        return kUsage;
    }
    std::vector<const char *> words(line.argv, line.argv + line.argc);
    auto end = std::find(words.begin(), words.end(), std::string_view("--")); // what follows are inputs
    for (const std::string &word : config->words) {
        end = words.insert(end, word.c_str()) + 1;
    }
    try {
        app.parse(static_cast<int>(words.size()), words.data());
        return std::nullopt;
    } catch (const CLI::CallForHelp &help) {
        return app.exit(help);
    } catch (const CLI::ExtrasError &) {
        return wrongUsage(app.get_name(), unexpectedArguments(app));
    } catch (const CLI::ParseError &error) {
        const std::string fault = parseFault(app, error);
        const auto place = config->places.find(fault.substr(0, fault.find(':')));
        return wrongUsage(app.get_name(), (place != config->places.end() ? place->second + ": " : "") + fault);
    }
}

int wrongUsage(const std::string &command, std::string_view message) {
    std::fprintf(stderr, "%s: %.*s\nRun with --help for more information.\n", command.c_str(),
                 static_cast<int>(message.size()), message.data());
    return kUsage;
}

} // namespace forefront
