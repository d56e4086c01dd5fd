#include "app/batch/strip_option.hpp"

#include "app/batch/named_tags.hpp"
#include "app/batch/setting_list.hpp"
#include "core/engine/base/enum_words.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

namespace forefront {

namespace {

/// Parses a whole text as a number.
template <class Number>
bool parsesAs(std::string_view text, Number &value) {
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    return fault == std::errc() && end == text.data() + text.size();
}

/// Sets one value of a strip. Returns what is wrong.
std::string setStripValue(std::string_view key, std::string_view value, StripSpec &spec) {
    if (key == "type") {
        return setWord("type", value, spec.cells);
    }
    const bool valid = key == "width"  ? parsesAs(value, spec.width)
                       : key == "rows" ? parsesAs(value, spec.rows)
                                       : parsesAs(value, spec.region) && spec.region > 0;
    return valid ? ""
                 : "expected a " + std::string(key == "width" ? "number" : "whole number above 0") + " for " +
                       std::string(key) + ", got '" + std::string(value) + "'";
}

/// Parses one value of --strip. Returns what is wrong.
std::string parseStrip(const std::string &text, StripArguments::Strip &strip) {
    static constexpr std::array<std::string_view, 4> kKnown = {"width", "rows", "type", "region"};
    SettingList list;
    const auto set = [&](std::string_view key, std::string_view value) {
        return setStripValue(key, value, strip.spec);
    };
    if (std::string wrong = readSettings(
            text, {kKnown, "width, rows, type or region", "NAME:width=W,rows=N, such as wall:width=0.2,rows=2", set},
            list);
        !wrong.empty()) {
        return wrong;
    }
    strip.name = list.name;
    for (const char *const needed : {"width", "rows"}) {
        if (!list.has(needed)) {
            return std::string(needed) + " is missing; expected NAME:width=W,rows=N";
        }
    }
    const std::optional<Diagnostic> fault = stripFault(strip.spec, strip.name);
    return fault ? fault->message + "; " + fault->advice : std::string();
}

} // namespace

void addStripOption(CLI::App &app, StripArguments &arguments, const char *help) {
    app.add_option("--strip", arguments.texts, help)->allow_extra_args(false)->type_name("NAME:KEY=VALUE,...");
}

std::string parseStrips(StripArguments &arguments) {
    for (const std::string &text : arguments.texts) {
        if (const std::string wrong = parseStrip(text, arguments.strips.emplace_back()); !wrong.empty()) {
            return std::string("--strip ").append(text).append(": ").append(wrong);
        }
    }
    return {};
}

Diagnostics applyStrips(const StripArguments &arguments, const Domain &domain, std::vector<StripSpec> &strips) {
    const NamedTags parts = NamedTags::ofParts(domain);
    for (const StripArguments::Strip &strip : arguments.strips) {
        const std::optional<std::int32_t> tag = parts.find(strip.name);
        if (!tag) {
            return parts.unknown("--strip", strip.name);
        }
        std::erase_if(strips, [&](const StripSpec &own) { return own.tag == *tag; });
        strips.push_back(strip.spec);
        strips.back().tag = *tag;
    }
    return {};
}

} // namespace forefront
