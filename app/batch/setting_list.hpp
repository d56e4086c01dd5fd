#pragma once

#include "app/batch/suggestion.hpp"
#include "core/engine/base/enum_words.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// A text such as wing:first=1e-4,growth=1.2: a name, which may hold colons, and settings KEY=VALUE.
struct SettingList {
    std::string name;
    std::vector<std::string_view> keys; ///< that are given, each once; views of the text that was read

    bool has(std::string_view key) const;
};

/// What the texts of an option may hold.
struct SettingRules {
    std::span<const std::string_view> known; ///< keys
    const char *keys;                        ///< the same in words, such as "width or rows"
    const char *example;                     ///< of a whole text, with what is needed, for messages
    /// Sets one value; returns what is wrong with it, empty if nothing is.
    std::function<std::string(std::string_view key, std::string_view value)> set;
};

/// Sets a value to the one of its enumeration that has the name `word`. Returns what is wrong; `what`: such as "type".
template <class Enum>
std::string setWord(const std::string &what, std::string_view word, Enum &value) {
    const std::optional<Enum> known = fromWord<Enum>(word);
    value = known.value_or(value);
    return known ? std::string()
                 : "unknown " + what + " '" + std::string(word) + "'; expected " + wordList<Enum>() +
                       suggestion(word, wordsOf<Enum>());
}

/// Reads a text into `list`, which views it. Returns what is wrong; empty if nothing is.
std::string readSettings(std::string_view text, const SettingRules &rules, SettingList &list);

} // namespace forefront
