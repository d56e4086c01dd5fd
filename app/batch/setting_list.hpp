#pragma once

#include <functional>
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

/// Reads a text into `list`, which views it. Returns what is wrong; empty if nothing is.
std::string readSettings(std::string_view text, const SettingRules &rules, SettingList &list);

} // namespace forefront
