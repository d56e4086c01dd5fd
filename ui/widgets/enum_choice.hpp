#pragma once

#include "core/engine/base/enum_words.hpp"
#include "ui/widgets/widgets.hpp"

#include <array>
#include <string>

namespace forefront::ui {

/// Returns the words of an enumeration as labels: "Fast", "Classic"; digits stay.
template <class Enum>
std::span<const char *const> enumLabels() {
    static const auto texts = [] {
        std::array<std::string, wordsOf<Enum>().size()> list;
        for (std::size_t i = 0; i < list.size(); ++i) {
            list[i] = wordsOf<Enum>()[i];
            const char first = list[i][0];
            list[i][0] = first >= 'a' && first <= 'z' ? static_cast<char>(first - 'a' + 'A') : first;
        }
        return list;
    }();
    static const auto labels = [] {
        std::array<const char *, texts.size()> list{};
        for (std::size_t i = 0; i < list.size(); ++i) {
            list[i] = texts[i].c_str();
        }
        return list;
    }();
    return labels;
}

/// Draws the values of an enumeration side by side; returns true when the choice changed. Width as for segmented().
template <class Enum>
bool segmented(WidgetContext &context, std::string_view name, Enum &value, float width = 0.0F) {
    int choice = static_cast<int>(value);
    const bool changed = segmented(context, name, enumLabels<Enum>(), choice, width);
    value = static_cast<Enum>(choice);
    return changed;
}

/// Draws the values of an enumeration as a drop-down list; returns true when the choice changed.
template <class Enum>
bool combo(WidgetContext &context, std::string_view name, Enum &value) {
    int choice = static_cast<int>(value);
    const bool changed = combo(context, name, enumLabels<Enum>(), choice);
    value = static_cast<Enum>(choice);
    return changed;
}

} // namespace forefront::ui
