#pragma once

#include "core/engine/base/api.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace FOREFRONT_API forefront {

/// The words of an enumeration, shared by files, the command line and the user interface. Specialise it beside the
/// enumeration, whose values must be numbered from 0 without gaps:
///
///     template <>
///     struct EnumWords<Method> {
///         static constexpr auto kLast = Method::Classic;
///         static constexpr std::array<std::string_view, 2> kList = {"fast", "classic"};
///     };
template <class Enum>
struct EnumWords;

/// Returns true if each value up to kLast has a distinct word; checked at compile time wherever the words are used.
template <class Enum>
constexpr bool hasDistinctWords() {
    constexpr auto &list = EnumWords<Enum>::kList;
    if (list.size() != static_cast<std::size_t>(EnumWords<Enum>::kLast) + 1) {
        return false;
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (list[i].empty() || list[i] == list[j]) {
                return false;
            }
        }
    }
    return true;
}

/// Returns the words in the order of the values.
template <class Enum>
constexpr const auto &wordsOf() {
    static_assert(hasDistinctWords<Enum>(), "every value needs a distinct word");
    return EnumWords<Enum>::kList;
}

/// Returns all values, in order.
template <class Enum>
constexpr auto valuesOf() {
    std::array<Enum, wordsOf<Enum>().size()> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = static_cast<Enum>(i);
    }
    return values;
}

/// Returns the word of a value.
template <class Enum>
constexpr std::string_view wordOf(Enum value) {
    return wordsOf<Enum>()[static_cast<std::size_t>(value)];
}

/// Returns the value with this word, if any.
template <class Enum>
constexpr std::optional<Enum> fromWord(std::string_view word) {
    for (std::size_t i = 0; i < wordsOf<Enum>().size(); ++i) {
        if (wordsOf<Enum>()[i] == word) {
            return static_cast<Enum>(i);
        }
    }
    return std::nullopt;
}

/// Returns the words as "fast or classic" or "none, uniform or hierarchical", for messages.
template <class Enum>
std::string wordList() {
    std::string text;
    const auto &words = wordsOf<Enum>();
    for (std::size_t i = 0; i < words.size(); ++i) {
        text += i == 0 ? "" : i + 1 == words.size() ? " or " : ", ";
        text += words[i];
    }
    return text;
}

} // namespace forefront
