#include "app/batch/cli_options.hpp"
#include "app/batch/commands.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/option_table.hpp"
#include "app/batch/outputs.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

namespace {

constexpr const char *kCompletionExamples = R"help(
Examples:
  source <(forefront completion bash)
        complete in this shell; put the line into ~/.bashrc for all
  forefront completion zsh > ~/.zfunc/_forefront
        a function for zsh, in a folder of fpath
  forefront completion fish > ~/.config/fish/completions/forefront.fish
        read by fish when it first completes the command

Exit codes: 0 done, 1 cannot write, 2 usage error.)help";

constexpr std::array<std::string_view, 3> kShells = {"bash", "zsh", "fish"};

std::string joinedWords(const std::vector<std::string> &words, const char *separator) {
    std::string text;
    for (const std::string &word : words) {
        text += (text.empty() ? "" : separator) + word;
    }
    return text;
}

/// Returns the text between single quotes, as the shells take it; fish escapes a quote by a backslash.
std::string shellQuoted(std::string_view text, bool fish = false) {
    std::string quoted = "'";
    for (const char c : text) {
        quoted += c == '\'' ? std::string(fish ? "\\'" : "'\\''") : fish && c == '\\' ? "\\\\" : std::string(1, c);
    }
    return quoted + '\'';
}

/// What the editor's command does, which is not among the batch commands.
constexpr std::string_view kViewHelp = "Opens a mesh in the editor.";

/// Returns the first sentence or clause of a help text.
std::string briefly(std::string_view help) {
    return std::string(help.substr(0, help.find_first_of(";\n")));
}

std::string nameOf(const CommandInfo &command) {
    return command.name.substr(command.name.find(' ') + 1);
}

std::string bashCommand(const CommandInfo &command) {
    std::vector<std::string> names, positional;
    std::string values;
    for (const OptionInfo &option : command.options) {
        if (option.positional) {
            positional.insert(positional.end(), option.words.begin(), option.words.end());
            continue;
        }
        names.insert(names.end(), option.names.begin(), option.names.end());
        if (!option.isFlag()) {
            const std::string found = !option.words.empty() ? "words=" + shellQuoted(joinedWords(option.words, " "))
                                      : option.isPath       ? "files=1"
                                                            : "none=1";
            values += "        " + joinedWords(option.names, "|") + ") " + found + " ;;\n";
        }
    }
    return "    " + nameOf(command) + ")\n        options=" + shellQuoted(joinedWords(names, " ")) +
           "\n        arguments=" + shellQuoted(joinedWords(positional, " ")) + "\n        case \"$before\" in\n" +
           values + "        esac ;;\n";
}

std::string bashCompletion(const std::vector<CommandInfo> &commands) {
    std::string names = "view ", cases;
    for (const CommandInfo &command : commands) {
        names += nameOf(command) + ' ';
        cases += bashCommand(command);
    }
    return R"(# Completion of forefront for bash.
_forefront() {
    local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}
    local options= arguments= words= files= none=
    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then
        compopt -o default
        COMPREPLY=($(compgen -W ')" +
           names + R"(--version --help' -- "$current"))
        return
    fi
    if [ "$current" = = ]; then
        current=
    elif [ "$before" = = ]; then
        before=${COMP_WORDS[COMP_CWORD-2]}
    fi
    case "${COMP_WORDS[1]}" in
)" + cases +
           R"(    esac
    if [ -n "$words" ]; then
        COMPREPLY=($(compgen -W "$words" -- "$current"))
    elif [ -n "$files" ]; then
        compopt -o default
    elif [ -n "$none" ]; then
        return
    elif [ "${current:0:1}" = - ]; then
        COMPREPLY=($(compgen -W "$options" -- "$current"))
    elif [ -n "$arguments" ]; then
        COMPREPLY=($(compgen -W "$arguments" -- "$current"))
    else
        compopt -o default
    fi
}
complete -F _forefront forefront
)";
}

/// Returns a text in which the marks of an argument of zsh's _arguments are escaped.
std::string zshEscaped(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        escaped += c == '[' || c == ']' || c == ':' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
    }
    return escaped;
}

std::string zshValue(const OptionInfo &option) {
    const std::string word = zshEscaped(option.positional ? option.names.front() : option.value);
    return ':' + word + ':' +
           (!option.words.empty() ? '(' + joinedWords(option.words, " ") + ')'
            : option.isPath       ? "_files"
                                  : " ");
}

std::string zshCommand(const CommandInfo &command) {
    std::string text = "    " + nameOf(command) + ")\n        _arguments -S";
    for (const OptionInfo &option : command.options) {
        if (option.positional) {
            text += " \\\n            " + shellQuoted((option.repeats ? "*" : "") + zshValue(option));
            continue;
        }
        for (const std::string &name : option.names) {
            const std::string spelled = option.isFlag() ? name : name + (name.starts_with("--") ? "=" : "+");
            text += " \\\n            " + shellQuoted('*' + spelled + '[' + zshEscaped(briefly(option.help)) + ']' +
                                                      (option.isFlag() ? std::string() : zshValue(option)));
        }
    }
    return text + " ;;\n";
}

std::string zshCompletion(const std::vector<CommandInfo> &commands) {
    std::string names = "            'view:" + std::string(kViewHelp) + "'\n", cases;
    for (const CommandInfo &command : commands) {
        names += "            " + shellQuoted(nameOf(command) + ':' + command.description) + '\n';
        cases += zshCommand(command);
    }
    return "#compdef forefront\n# Completion of forefront for zsh.\n_forefront() {\n"
           "    if (( CURRENT == 2 )); then\n        local -a commands=(\n" +
           names +
           "        )\n        _describe command commands\n        _files\n        return\n    fi\n"
           "    local command=$words[2]\n    shift words\n    (( CURRENT-- ))\n    case $command in\n" +
           cases +
           "    *) _files ;;\n    esac\n}\n"
           "if [ \"$funcstack[1]\" = _forefront ]; then\n    _forefront \"$@\"\nelse\n    compdef _forefront "
           "forefront\nfi\n";
}

std::string fishCompletion(const std::vector<CommandInfo> &commands) {
    std::string text =
        "# Completion of forefront for fish.\ncomplete -c forefront -n __fish_use_subcommand -a view -d '" +
        std::string(kViewHelp) + "'\n";
    for (const CommandInfo &command : commands) {
        const std::string name = nameOf(command);
        text += "complete -c forefront -n __fish_use_subcommand -a " + name + " -d " +
                shellQuoted(command.description, true) + '\n';
        const std::string begin = "complete -c forefront -n '__fish_seen_subcommand_from " + name + '\'';
        for (const OptionInfo &option : command.options) {
            if (option.positional && option.words.empty()) {
                continue;
            }
            text += begin;
            for (const std::string &spelled : option.names) {
                text += option.positional           ? ""
                        : spelled.starts_with("--") ? " -l " + spelled.substr(2)
                                                    : " -s " + spelled.substr(1);
            }
            text += option.isFlag()         ? ""
                    : !option.words.empty() ? " -x -a " + shellQuoted(joinedWords(option.words, " "), true)
                    : option.isPath         ? " -r -F"
                                            : " -x";
            text += " -d " + shellQuoted(briefly(option.help), true) + '\n';
        }
    }
    return text;
}

} // namespace

int completionCommand(const CommandLine &line) {
    std::string shell;
    CLI::App app("Prints a script that completes commands, options and their values in a shell.",
                 "forefront completion");
    app.footer(kCompletionExamples);
    app.add_option("SHELL", shell, "bash, zsh or fish")->required()->check(oneOf(kShells));
    if (const auto code = parseOptions(app, line)) {
        return *code;
    }
    const std::vector<CommandInfo> commands = describeCommands();
    const Status printed = printText(shell == "bash"  ? bashCompletion(commands)
                                     : shell == "zsh" ? zshCompletion(commands)
                                                      : fishCompletion(commands));
    printFaults(printed);
    return printed.empty() ? kDone : kRefused;
}

} // namespace forefront
