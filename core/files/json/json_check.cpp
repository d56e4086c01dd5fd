#include "core/files/json/json_check.hpp"

#include "core/files/common/names.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <string>

namespace forefront {

void JsonCheck::fault(const JsonValue &value, std::string code, std::string message, std::string advice) {
    if (!full()) {
        faults_.push_back(faultAt(source_, value.offset(), std::move(code), std::move(message), std::move(advice)));
    }
}

void JsonCheck::warn(const JsonValue &value, std::string_view code, const std::string &message) const {
    source_.warn(code, message, value.offset());
}

void JsonCheck::noteUnknown(const JsonValue &object, std::span<const std::string_view> known) const {
    if (!object.is(JsonKind::Object)) {
        return; // reported as a fault
    }
    for (auto member = object.begin(); member != object.end(); ++member) {
        const std::string key = member.key();
        if (std::find(known.begin(), known.end(), key) == known.end()) {
            source_.note("members", "unknown member " + inQuotes(key) + " is ignored", member.keyValue().offset());
        }
    }
}

void JsonCheck::refuseRepeats(const JsonValue &value) {
    if (value.is(JsonKind::Object)) {
        std::map<std::string, std::size_t> places;
        for (auto member = value.begin(); member != value.end(); ++member) {
            const auto [first, added] = places.emplace(member.key(), member.keyValue().offset());
            if (!added) {
                fault(member.keyValue(), "duplicate-member",
                      "duplicate member " + inQuotes(first->first) + "; the first is in line " +
                          std::to_string(placeOf(source_.text, first->second).line),
                      "remove one of them");
            }
        }
    }
    if (value.is(JsonKind::Object) || value.is(JsonKind::Array)) {
        for (const JsonValue item : value) {
            refuseRepeats(item);
        }
    }
}

std::optional<JsonValue> JsonCheck::member(const JsonValue &object, std::string_view name, std::string_view of) {
    const auto value = object.find(name);
    if (!value) {
        fault(object, "missing-field", std::string(of) + " has no \"" + std::string(name) + '"');
    }
    return value;
}

bool JsonCheck::expect(const JsonValue &value, JsonKind kind, std::string_view what) {
    if (value.is(kind)) {
        return true;
    }
    const char *name = kind == JsonKind::Array    ? "a list"
                       : kind == JsonKind::Object ? "an object"
                       : kind == JsonKind::String ? "a string"
                                                  : "a number";
    fault(value, "bad-field", std::string("expected ") + name + " for " + std::string(what));
    return false;
}

double JsonCheck::number(const JsonValue &value, std::string_view what) {
    const auto result = value.number();
    if (!result) {
        fault(value, "bad-number", "expected a number for " + std::string(what));
    }
    return result.value_or(0.0);
}

double JsonCheck::positive(const JsonValue &value, std::string_view what) {
    const auto result = value.number();
    if (!result || !(*result > 0.0)) {
        fault(value, "bad-number", "expected a number greater than 0 for " + std::string(what));
        return 1.0;
    }
    return *result;
}

double JsonCheck::notNegative(const JsonValue &value, std::string_view what) {
    const auto result = value.number();
    if (!result || *result < 0.0) {
        fault(value, "bad-number", "expected a number of at least 0 for " + std::string(what));
        return 0.0;
    }
    return *result;
}

std::int64_t JsonCheck::integer(const JsonValue &value, std::int64_t minimum, std::int64_t maximum,
                                std::string_view what) {
    const auto result = value.integer();
    if (!result || *result < minimum || *result > maximum) {
        fault(value, "bad-number",
              "expected an integer from " + std::to_string(minimum) + " to " + std::to_string(maximum) + " for " +
                  std::string(what));
        return minimum;
    }
    return *result;
}

std::int32_t JsonCheck::tag(const JsonValue &value) {
    return static_cast<std::int32_t>(integer(value, 1, std::numeric_limits<std::int32_t>::max(), "a tag"));
}

bool JsonCheck::flag(const JsonValue &value, std::string_view what) {
    if (!value.is(JsonKind::True) && !value.is(JsonKind::False)) {
        fault(value, "bad-field", "expected true or false for " + std::string(what));
    }
    return value.is(JsonKind::True);
}

std::string JsonCheck::string(const JsonValue &value, std::string_view what) {
    return expect(value, JsonKind::String, what) ? validUtf8(value.string()) : std::string();
}

Vec2 JsonCheck::point(const JsonValue &value, std::string_view what) {
    double numbers[2] = {0.0, 0.0};
    std::size_t count = 0;
    for (const JsonValue item : value) {
        const auto coordinate = item.number();
        if (!coordinate) {
            fault(item, "bad-number", "expected a number as coordinate of " + std::string(what));
            return {};
        }
        if (count < 2) {
            numbers[count] = *coordinate;
        }
        ++count;
    }
    if (!value.is(JsonKind::Array) || count != 2) {
        fault(value, "bad-number", "expected 2 numbers, [x, y], for " + std::string(what));
    }
    return {numbers[0], numbers[1]};
}

std::vector<Vec2> JsonCheck::points(const JsonValue &list, std::string_view what) {
    std::vector<Vec2> nodes;
    for (const JsonValue node : list) {
        if (full()) {
            break;
        }
        nodes.push_back(point(node, what));
    }
    return nodes;
}

std::size_t JsonCheck::choice(const JsonValue &value, std::span<const std::string_view> words, std::string_view what) {
    const std::string word = value.string();
    std::string list;
    for (std::size_t k = 0; k < words.size(); ++k) {
        if (words[k] == word) {
            return k;
        }
        list += (k == 0 ? "\"" : ", \"") + std::string(words[k]) + '"';
    }
    fault(value, "bad-field", "expected one of " + list + " for " + std::string(what));
    return 0;
}

} // namespace forefront
