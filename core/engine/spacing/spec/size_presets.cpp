#include "core/engine/spacing/spec/size_presets.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

namespace forefront {
namespace {

using Keys = std::map<std::string, std::string, std::less<>>;

struct SizePreset {
    std::string_view word;
    std::string_view keys;     ///< with spaces around each
    std::string_view required; ///< separated by spaces, without the raster
    bool raster;               ///< needs depth or elevation
    std::string (*expression)(const Keys &);
};

std::string valueOr(const Keys &keys, std::string_view key, std::string_view other) {
    const auto found = keys.find(key);
    return found == keys.end() ? std::string(other) : found->second;
}

std::string rasterName(const Keys &keys) {
    return valueOr(keys, "depth", valueOr(keys, "elevation", ""));
}

/// Returns the depth at a place, at least the least that counts.
std::string depthText(const Keys &keys) {
    const bool negative = !keys.contains("depth");
    return "max(" + std::string(negative ? "-" : "") + rasterName(keys) + "(x,y), " + valueOr(keys, "least", "1") + ")";
}

std::string wavelength(const Keys &keys) {
    return keys.at("period") + "/" + keys.at("elements") + "*sqrt(9.81*" + depthText(keys) + ")";
}

std::string slope(const Keys &keys) {
    const std::string name = rasterName(keys);
    // A flat bed has no length scale; the tiny slope keeps the quotient finite and leaves it to the maximum.
    return "2*pi/" + keys.at("elements") + "*" + depthText(keys) + "/max(hypot(" + name + "_x(x,y), " + name +
           "_y(x,y)), 1e-9)";
}

std::string shore(const Keys &keys) {
    const std::string part = valueOr(keys, "part", "");
    return keys.at("size") + " + " + keys.at("growth") + "*shore(x,y" + (part.empty() ? "" : ", '" + part + "'") + ")";
}

constexpr std::array<SizePreset, 3> kPresets{{
    {"wavelength", " depth elevation period elements least min max ", "period elements", true, wavelength},
    {"slope", " depth elevation elements least min max ", "elements max", true, slope},
    {"shore", " part size growth min max ", "size growth", false, shore},
}};

Diagnostics wrongPreset(const std::string &rule, const std::string &message) {
    return error("bad-preset", "'" + rule + "': " + message, "expected " + sizePresetHelp());
}

bool isNumber(const std::string &text) {
    double value = 0.0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    return status == std::errc() && end == text.data() + text.size() && std::isfinite(value) && value > 0.0;
}

bool isName(std::string_view text) {
    return !text.empty() && (text.front() < '0' || text.front() > '9') &&
           std::all_of(text.begin(), text.end(), [](char c) {
               return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
           });
}

/// Returns what is wrong with a key of a rule; empty if nothing is.
std::string keyFault(const SizePreset &preset, const std::string &key, const std::string &value) {
    if (preset.keys.find(" " + key + " ") == std::string_view::npos) {
        return "unknown key '" + key + "'; expected" + std::string(preset.keys.substr(0, preset.keys.size() - 1));
    }
    if (key == "part") {
        return value.empty() || value.find('\'') != std::string::npos ? "part: expected the name of a boundary part"
                                                                      : "";
    }
    if (key == "depth" || key == "elevation") {
        return isName(value) ? "" : key + ": expected the name of a raster, got '" + value + "'";
    }
    return isNumber(value) ? "" : key + ": expected a positive number, got '" + value + "'";
}

/// Reads KEY=VALUE,... into `keys`; returns what is wrong, empty if nothing is.
std::string readKeys(const SizePreset &preset, std::string_view text, Keys &keys) {
    while (!text.empty()) {
        const std::string_view item = text.substr(0, text.find(','));
        text.remove_prefix(std::min(text.size(), item.size() + 1));
        const std::size_t equals = item.find('=');
        if (equals == std::string_view::npos) {
            return "expected KEY=VALUE, got '" + std::string(item) + "'";
        }
        const std::string key(item.substr(0, equals)), value(item.substr(equals + 1));
        std::string wrong = keyFault(preset, key, value);
        if (!wrong.empty()) {
            return wrong;
        }
        if (!keys.emplace(key, value).second) {
            return "duplicate key '" + key + "'";
        }
    }
    for (std::string_view rest = preset.required; !rest.empty();) {
        const std::string_view key = rest.substr(0, rest.find(' '));
        rest.remove_prefix(std::min(rest.size(), key.size() + 1));
        if (!keys.contains(key)) {
            return "missing key '" + std::string(key) + "'";
        }
    }
    if (preset.raster && keys.contains("depth") == keys.contains("elevation")) {
        return "expected a raster: depth=NAME, or elevation=NAME";
    }
    return {};
}

/// A rule that was read.
struct ReadRule {
    const SizePreset *preset = nullptr;
    Keys keys;
};

Result<ReadRule> readRule(const std::string &rule) {
    const std::size_t colon = std::min(rule.find(':'), rule.size());
    const auto preset = std::find_if(kPresets.begin(), kPresets.end(), [&](const SizePreset &each) {
        return each.word == std::string_view(rule).substr(0, colon);
    });
    if (preset == kPresets.end()) {
        return wrongPreset(rule, "unknown rule; expected wavelength, slope or shore");
    }
    ReadRule read{&*preset, {}};
    const std::string wrong = readKeys(
        *preset, colon < rule.size() ? std::string_view(rule).substr(colon + 1) : std::string_view(), read.keys);
    return wrong.empty() ? Result<ReadRule>(std::move(read)) : wrongPreset(rule, wrong);
}

Result<std::string> expressionOf(const std::string &rule) {
    const Result<ReadRule> read = readRule(rule);
    if (!read) {
        return read.faults();
    }
    const Keys &keys = read->keys;
    std::string text = read->preset->expression(keys);
    if (keys.contains("max")) {
        text = "min(" + text + ", " + keys.at("max") + ")";
    }
    if (keys.contains("min")) {
        text = "max(" + text + ", " + keys.at("min") + ")";
    }
    return text;
}

} // namespace

Result<std::string> presetExpression(std::span<const std::string> rules) {
    std::string all;
    for (const std::string &rule : rules) {
        Result<std::string> text = expressionOf(rule);
        if (!text) {
            return text.faults();
        }
        all += (all.empty() ? "" : ", ") + *text;
    }
    return rules.size() > 1 ? "min(" + all + ")" : all;
}

std::vector<PresetDepth> presetDepths(std::span<const std::string> rules) {
    std::vector<PresetDepth> depths;
    for (const std::string &rule : rules) {
        if (const Result<ReadRule> read = readRule(rule); read && read->preset->raster) {
            depths.push_back({rule, rasterName(read->keys), !read->keys.contains("depth")});
        }
    }
    return depths;
}

bool countsAllAsShore(std::span<const std::string> rules) {
    return std::any_of(rules.begin(), rules.end(), [](const std::string &rule) {
        const Result<ReadRule> read = readRule(rule);
        return read && read->preset->word == "shore" && !read->keys.contains("part");
    });
}

std::string sizePresetHelp() {
    return "wavelength:depth=NAME,period=SECONDS,elements=N; slope:depth=NAME,elements=N,max=H; "
           "shore:size=H,growth=G[,part=NAME], without a part from the whole boundary; each with min=H, max=H; "
           "elevation=NAME in place of depth=NAME; least=D, the least depth that counts (default 1)";
}

} // namespace forefront
