#include "app/batch/option_table.hpp"

#include <algorithm>
#include <utility>

namespace forefront {

namespace {

constexpr std::string_view kWordsMark = "words:"; // before the words in the name of a validator

std::vector<std::string> splitAtCommas(std::string_view text) {
    std::vector<std::string> words;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(','));
        text.remove_prefix(std::min(text.size(), word.size() + 1));
        const std::size_t first = word.find_first_not_of(' ');
        if (first != std::string_view::npos) {
            words.emplace_back(word.substr(first));
        }
    }
    return words;
}

/// Returns the words that the validators of an option know.
std::vector<std::string> wordsOfOption(CLI::Option &option) {
    for (int k = 0;; ++k) {
        try {
            const std::string &name = option.get_validator(k)->get_name();
            if (name.starts_with(kWordsMark)) {
                return splitAtCommas(std::string_view(name).substr(kWordsMark.size()));
            }
        } catch (const CLI::OptionNotFound &) {
            return {};
        }
    }
}

bool namesFile(std::string_view value) {
    const auto isWord = [&](std::string_view word) { return value == word; };
    constexpr std::string_view kPaths[] = {"FILE", "FILE.json", "FILE.toml", "FILE|EXPR", "OUT", "IN", "PROJECT"};
    return std::any_of(std::begin(kPaths), std::end(kPaths), isWord);
}

OptionInfo describeOption(CLI::Option &option) {
    OptionInfo info;
    info.positional = option.get_positional();
    if (info.positional) {
        info.names.push_back(option.get_name());
    }
    for (const std::string &name : option.get_snames()) {
        info.names.push_back("-" + name);
    }
    for (const std::string &name : option.get_lnames()) {
        info.names.push_back("--" + name);
    }
    const bool flag = !info.positional && option.get_items_expected_max() == 0;
    info.value = flag ? std::string() : info.positional ? option.get_name() : option.get_type_name();
    info.help = option.get_description();
    info.words = wordsOfOption(option);
    for (const CLI::Option *other : option.get_excludes()) {
        for (const std::string &name : other->get_lnames()) {
            info.excluded.push_back("--" + name);
        }
    }
    info.required = option.get_required();
    info.repeats = option.get_items_expected_max() > 1;
    info.isPath =
        info.positional ? option.get_name() != "SHELL" && option.get_name() != "COMMAND" : namesFile(info.value);
    return info;
}

/// Adds the options of an app and of its groups. Of a group that takes one option, each excludes the others.
void addOptions(CLI::App &app, CommandInfo &info) {
    const std::size_t first = info.options.size();
    for (CLI::Option *option : app.get_options()) {
        if (option->get_name() != "--help" || info.find("--help") == nullptr) {
            info.options.push_back(describeOption(*option));
        }
    }
    if (app.get_name().empty() && app.get_require_option_max() == 1) {
        for (std::size_t k = first; k < info.options.size(); ++k) {
            for (std::size_t j = first; j < info.options.size(); ++j) {
                if (j != k) {
                    info.options[k].excluded.push_back(info.options[j].names.back());
                }
            }
        }
    }
    for (CLI::App *const group : app.get_subcommands([](CLI::App *) { return true; })) {
        addOptions(*group, info);
    }
}

} // namespace

const OptionInfo *CommandInfo::find(std::string_view option) const {
    const auto found = std::find_if(options.begin(), options.end(), [&](const OptionInfo &each) {
        return !each.positional && std::find(each.names.begin(), each.names.end(), option) != each.names.end();
    });
    return found != options.end() ? &*found : nullptr;
}

CommandInfo describeCommand(CLI::App &app) {
    CommandInfo info{app.get_name(), app.get_description(), app.get_footer(), {}};
    addOptions(app, info);
    return info;
}

CLI::Validator withWords(CLI::Validator validator, std::span<const std::string_view> words) {
    std::string name(kWordsMark);
    for (const std::string_view word : words) {
        name += std::string(word) + ',';
    }
    return validator.name(std::move(name));
}

CLI::Validator offering(std::span<const std::string_view> words) {
    return withWords(CLI::Validator([](const std::string &) { return std::string(); }, ""), words);
}

CLI::Validator offering(std::string_view words) {
    return offering(std::span(&words, 1));
}

} // namespace forefront
