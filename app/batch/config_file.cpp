#include "app/batch/config_file.hpp"

#include "app/batch/elevation_option.hpp"
#include "app/batch/suggestion.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/files/source/source.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#define TOML_HEADER_ONLY 1
#include <toml++/toml.h>

namespace forefront {

namespace {

constexpr std::size_t kMaxConfigBytes = std::size_t{1} << 20;

Diagnostic configFault(const std::filesystem::path &file, const toml::source_region &source, std::string code,
                       std::string message) {
    Diagnostic fault = error(std::move(code), std::move(message)).front();
    fault.file = file.string();
    fault.line = static_cast<int>(source.begin.line);
    fault.column = static_cast<int>(source.begin.column);
    return fault;
}

/// Returns the text of a value that is not an array or table; empty if it is a date or time.
std::optional<std::string> scalarText(const toml::node &node) {
    if (const auto *const text = node.as_string()) {
        return text->get();
    }
    if (const auto *const whole = node.as_integer()) {
        return std::to_string(whole->get());
    }
    if (const auto *const number = node.as_floating_point()) {
        return exactText(number->get());
    }
    return std::nullopt;
}

/// Collects the options of one file.
class ConfigReader {
  public:
    ConfigReader(const std::filesystem::path &file, const CommandInfo &command,
                 const std::vector<std::string_view> &commands, const std::vector<std::string> &given)
        : file_(file), command_(command), commands_(commands), given_(given),
          own_(command.name.substr(command.name.find(' ') + 1)) {}

    Result<ConfigOptions> read(const toml::table &root) {
        const toml::table *section = nullptr;
        for (const auto &[key, node] : inOrder(root)) {
            const std::string_view name = key->str();
            const bool isCommand = std::find(commands_.begin(), commands_.end(), name) != commands_.end();
            if (isCommand && !node->is_table()) {
                fault(key->source(), "bad-value", "expected a table of options, such as [" + std::string(name) + ']');
            } else if (isCommand && name == own_) {
                section = node->as_table();
            } else if (!isCommand) {
                addOption(*key, *node, root.contains(own_) ? root.get(own_)->as_table() : nullptr);
            }
        }
        if (section != nullptr) {
            for (const auto &[key, node] : inOrder(*section)) {
                addOption(*key, *node, nullptr);
            }
        }
        if (!faults_.empty()) {
            return faults_;
        }
        return std::move(options_);
    }

  private:
    /// Returns the entries of a table by their places in the file.
    static std::vector<std::pair<const toml::key *, const toml::node *>> inOrder(const toml::table &table) {
        std::vector<std::pair<const toml::key *, const toml::node *>> entries;
        for (const auto &[key, node] : table) {
            entries.emplace_back(&key, &node);
        }
        std::sort(entries.begin(), entries.end(), [](const auto &a, const auto &b) {
            const toml::source_position &p = a.first->source().begin, &q = b.first->source().begin;
            return std::pair(p.line, p.column) < std::pair(q.line, q.column);
        });
        return entries;
    }

    void fault(const toml::source_region &source, std::string code, std::string message) {
        faults_.push_back(configFault(file_, source, std::move(code), std::move(message)));
    }

    /// `stronger`: a table whose options replace this one; may be null.
    void addOption(const toml::key &key, const toml::node &node, const toml::table *stronger) {
        const std::string name = "--" + std::string(key.str());
        const OptionInfo *const option = command_.find(name);
        if (option == nullptr || name == "--help" || name == "--config") {
            fault(key.source(), "unknown-option", unknownKey(key.str()));
            return;
        }
        const auto isGiven = [&](const std::string &other) {
            const std::string_view bare = std::string_view(other).substr(2);
            return std::find(given_.begin(), given_.end(), other) != given_.end() ||
                   (stronger != nullptr && stronger->contains(bare));
        };
        std::vector<std::string> words;
        if (!addValue(*option, key, node, words)) {
            return;
        }
        if (isGiven(name) || std::any_of(option->excluded.begin(), option->excluded.end(), isGiven)) {
            return;
        }
        options_.words.insert(options_.words.end(), words.begin(), words.end());
        options_.places[name] = file_.string() + ':' + std::to_string(key.source().begin.line);
    }

    std::string unknownKey(std::string_view key) const {
        std::vector<std::string_view> known(commands_);
        for (const OptionInfo &option : command_.options) {
            const std::string &longest = option.names.back();
            if (!option.positional && longest != "--help" && longest != "--config") {
                known.push_back(std::string_view(longest).substr(2));
            }
        }
        return "unknown option '" + std::string(key) + "' of " + command_.name + suggestion(key, known);
    }

    /// Appends the words of an option. Returns false if its value does not fit.
    bool addValue(const OptionInfo &option, const toml::key &key, const toml::node &node,
                  std::vector<std::string> &words) {
        const std::string &name = option.names.back();
        if (option.isFlag()) {
            const auto *const flag = node.as_boolean();
            if (flag == nullptr) {
                fault(node.source(), "bad-value", std::string(key.str()) + ": expected true or false");
            } else if (flag->get()) {
                words.push_back(name);
            }
            return flag != nullptr;
        }
        if (const toml::table *const table = node.as_table(); table != nullptr && name == "--set") {
            for (const auto &[parameter, value] : inOrder(*table)) {
                if (!addText(option, *parameter, *value, std::string(parameter->str()) + '=', words)) {
                    return false;
                }
            }
            return true;
        }
        if (const toml::array *const list = node.as_array(); list != nullptr && option.repeats) {
            return std::all_of(list->begin(), list->end(),
                               [&](const toml::node &each) { return addText(option, key, each, {}, words); });
        }
        return addText(option, key, node, {}, words);
    }

    bool addText(const OptionInfo &option, const toml::key &key, const toml::node &node, const std::string &before,
                 std::vector<std::string> &words) {
        const std::optional<std::string> text = scalarText(node);
        if (!text) {
            fault(node.source(), "bad-value",
                  std::string(key.str()) + ": expected a number or a text" +
                      (option.repeats ? ", or an array of these" : ""));
            return false;
        }
        words.push_back(option.names.back() + '=' + before + (option.isPath ? placed(option, *text) : *text));
        return true;
    }

    /// Returns a path relative to the file as one relative to the current folder.
    std::string placed(const OptionInfo &option, const std::string &text) const {
        const bool isExpression = option.value == "FILE|EXPR" && !isElevationFile(text);
        return isExpression || text == "-" ? text : (file_.parent_path() / text).string();
    }

    const std::filesystem::path &file_;
    const CommandInfo &command_;
    const std::vector<std::string_view> &commands_;
    const std::vector<std::string> &given_;
    std::string own_;
    ConfigOptions options_;
    Diagnostics faults_;
};

} // namespace

Result<ConfigOptions> readConfig(const std::filesystem::path &file, const CommandInfo &command,
                                 const std::vector<std::string_view> &commands, const std::vector<std::string> &given) {
    const Result<std::string> text = readFileBytes(file, kMaxConfigBytes);
    if (!text) {
        return text.faults();
    }
    try {
        const toml::table root = toml::parse(*text, file.string());
        return ConfigReader(file, command, commands, given).read(root);
    } catch (const toml::parse_error &wrong) {
        return Diagnostics{configFault(file, wrong.source(), "toml-syntax", std::string(wrong.description()))};
    }
}

} // namespace forefront
