#include "core/drawing_files/geojson/feature_names.hpp"

#include "core/files/common/names.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace forefront {

namespace {

constexpr std::array<std::string_view, 3> kNameKeys{"name", "Name", "NAME"};
constexpr std::string_view kLevelPrefix = "NAME_";
constexpr const char *kId = "id";

bool isNameKey(std::string_view key) {
    return std::find(kNameKeys.begin(), kNameKeys.end(), key) != kNameKeys.end();
}

/// Returns n of "NAME_n".
std::optional<int> levelOf(std::string_view key) {
    const bool level = key.size() == kLevelPrefix.size() + 1 && key.starts_with(kLevelPrefix) && key.back() >= '0' &&
                       key.back() <= '9';
    return level ? std::optional(key.back() - '0') : std::nullopt;
}

std::string textOf(const std::optional<JsonValue> &value) {
    return value ? cleanName(value->string()) : std::string();
}

std::string textOrNumberOf(const std::optional<JsonValue> &value) {
    return value && value->is(JsonKind::Number) ? cleanName(value->numeral()) : textOf(value);
}

/// Returns the text or number of a property; the member "id" of a feature stands in for a property of that name.
std::string nameIn(const JsonValue &feature, const std::string &key) {
    const auto properties = feature.find("properties");
    std::string name = properties ? textOrNumberOf(properties->find(key)) : std::string();
    return name.empty() && key == kId ? textOrNumberOf(feature.find(kId)) : name;
}

} // namespace

void FeatureNames::survey(const JsonValue &feature) {
    if (const auto properties = feature.find("properties")) {
        surveyProperties(*properties);
    }
    if (!textOrNumberOf(feature.find(kId)).empty()) {
        keys_.try_emplace(kId, false);
    }
}

void FeatureNames::surveyProperties(const JsonValue &properties) {
    unsigned levels = 0;
    for (auto member = properties.begin(); member != properties.end(); ++member) {
        const std::string key = member.key();
        const auto level = levelOf(key);
        const auto known = keys_.find(key);
        if (known != keys_.end() && known->second && !level) {
            continue; // a large map repeats few keys very often
        }
        const bool text = !textOf(*member).empty();
        if (text || (*member).is(JsonKind::Number)) {
            keys_[key] |= text;
        }
        named_ = named_ || (text && isNameKey(key));
        levels |= level && text ? 1U << static_cast<unsigned>(*level) : 0U;
    }
    levelled_ = levelled_ || levels != 0;
    levels_ &= levels != 0 ? levels : ~0U;
}

std::string FeatureNames::nameOf(const JsonValue &feature) const {
    if (key_) {
        return nameIn(feature, *key_);
    }
    const auto properties = feature.find("properties");
    if (!properties) {
        return {};
    }
    for (const std::string_view key : kNameKeys) {
        if (std::string name = textOf(properties->find(key)); !name.empty()) {
            return name;
        }
    }
    const auto key = levelKey();
    return key ? textOf(properties->find(*key)) : std::string();
}

bool FeatureNames::uses(std::string_view key) const {
    return key_ ? key == *key_ : isNameKey(key) || key == levelKey();
}

std::string FeatureNames::source() const {
    return key_ ? *key_ : levelKey().value_or(std::string(kNameKeys.front()));
}

std::vector<std::string> FeatureNames::keys() const {
    std::vector<std::string> keys;
    for (const auto &[key, text] : keys_) {
        keys.push_back(key);
    }
    return keys;
}

bool FeatureNames::offersText() const {
    return !key_ && std::any_of(keys_.begin(), keys_.end(), [](const auto &entry) { return entry.second; });
}

std::optional<std::string> FeatureNames::levelKey() const {
    if (named_ || !levelled_ || levels_ == 0) {
        return std::nullopt;
    }
    return std::string(kLevelPrefix) + static_cast<char>('0' + std::bit_width(levels_) - 1);
}

} // namespace forefront
