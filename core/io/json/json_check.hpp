#pragma once

#include "core/io/json/json.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace forefront {

/// Takes typed fields out of JSON values and collects what is wrong with them, each with its place. A wrong field
/// yields a harmless default, so that all faults of a file come out at once.
class JsonCheck {
  public:
    explicit JsonCheck(const SourceText &source) : source_(source) {}

    void fault(const JsonValue &value, std::string code, std::string message, std::string advice = {});
    const Diagnostics &faults() const { return faults_; }
    /// True once so many faults were found that no more are kept.
    bool full() const { return faults_.size() >= kMost; }

    /// The member, or a fault that it is missing.
    std::optional<JsonValue> member(const JsonValue &object, std::string_view name, std::string_view of);
    /// True if the value is of that kind; else a fault.
    bool expect(const JsonValue &value, JsonKind kind, std::string_view what);

    double number(const JsonValue &value, std::string_view what);
    /// A number > 0.
    double positive(const JsonValue &value, std::string_view what);
    double notNegative(const JsonValue &value, std::string_view what);
    std::int64_t integer(const JsonValue &value, std::int64_t least, std::int64_t greatest, std::string_view what);
    std::int32_t tag(const JsonValue &value);
    bool flag(const JsonValue &value, std::string_view what);
    std::string string(const JsonValue &value, std::string_view what);
    /// An array of exactly two numbers.
    Vec2 point(const JsonValue &value, std::string_view what);
    /// Index of one of `words`.
    std::size_t choice(const JsonValue &value, std::span<const std::string_view> words, std::string_view what);

  private:
    static constexpr std::size_t kMost = 50;
    const SourceText &source_;
    Diagnostics faults_;
};

} // namespace forefront
