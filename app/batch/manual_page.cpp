#include "app/batch/manual_page.hpp"

#include "core/engine/base/version.hpp"

#include <algorithm>

namespace forefront {

namespace {

/// Returns a text that troff prints as it is. A line must not begin with a control character.
std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n')) {
            result += "\\&";
        }
        result += c == '\\' ? "\\e" : c == '-' ? "\\-" : c == '\'' ? "\\(aq" : c == '`' ? "\\(ga" : std::string(1, c);
    }
    return result;
}

/// Returns lines that keep their breaks and spaces.
std::string literal(std::string_view lines) {
    while (lines.starts_with('\n')) {
        lines.remove_prefix(1);
    }
    while (lines.ends_with('\n')) {
        lines.remove_suffix(1);
    }
    return ".nf\n" + escaped(lines) + "\n.fi\n";
}

/// Returns the part of a text between two words; to the end if the second is not found.
std::string_view between(std::string_view text, std::string_view first, std::string_view last) {
    const std::size_t from = text.find(first);
    if (from == std::string_view::npos) {
        return {};
    }
    const std::size_t begin = from + first.size(), end = text.find(last, begin);
    return text.substr(begin, end == std::string_view::npos ? end : end - begin);
}

std::string optionText(const OptionInfo &option) {
    std::string text = ".TP\n";
    std::string names;
    for (const std::string &name : option.names) {
        names +=
            (names.empty() ? "" : ", ") + std::string(option.positional ? "\\fI" : "\\fB") + escaped(name) + "\\fR";
    }
    text += names;
    if (!option.positional && !option.isFlag()) {
        text += " \\fI" + escaped(option.value) + "\\fR";
    }
    return text + '\n' + escaped(option.help) + '\n';
}

std::string commandText(const CommandInfo &command) {
    std::string text =
        ".SS " + escaped(command.name.substr(command.name.find(' ') + 1)) + '\n' + escaped(command.description) + '\n';
    for (const OptionInfo &option : command.options) {
        if (option.names.back() != "--help") {
            text += optionText(option);
        }
    }
    std::string_view footer = command.footer;
    footer = footer.substr(0, footer.find("Exit codes:")); // told once, for all
    return footer.find_first_not_of('\n') == std::string_view::npos ? text : text + ".PP\n" + literal(footer);
}

} // namespace

std::string manualPage(std::string_view usage, const std::vector<CommandInfo> &commands) {
    const std::string_view title = usage.substr(0, usage.find('\n'));
    const std::string_view about = title.substr(title.find(": ") + 2);
    std::string text = ".TH FOREFRONT 1 \"\" \"Forefront " + std::string(version()) + "\" \"User Commands\"\n";
    text += ".SH NAME\nforefront \\- " + escaped(about.substr(0, about.find_last_not_of('.') + 1)) + '\n';
    text += ".SH SYNOPSIS\n" + literal(between(usage, "\n\n", "\nExamples:"));
    text += ".SH COMMANDS\n";
    for (const CommandInfo &command : commands) {
        text += commandText(command);
    }
    text += ".SH EXIT STATUS\n" + escaped(between(usage, "Exit codes: ", "\n")) + '\n';
    return text + ".SH EXAMPLES\n" + literal(between(usage, "Examples:\n", "\nExit codes:"));
}

} // namespace forefront
