#pragma once

#include "core/files/json/json.hpp"

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// Extracts typed fields from JSON values and collects their faults with their places. A wrong field yields a harmless
/// default, so that all faults of a file are reported at once.
class JsonCheck {
  public:
    explicit JsonCheck(const SourceText &source) : source_(source) {}

    void fault(const JsonValue &value, std::string code, std::string message, std::string advice = {});
    const Diagnostics &faults() const { return faults_; }
    /// Returns the line and column of a value.
    TextPlace place(const JsonValue &value) const { return placeOf(source_.text, value.offset()); }
    /// Warns that a value, which is read as it is, may not be what a user expects.
    void warn(const JsonValue &value, std::string_view code, const std::string &message) const;
    /// Reports members of an object that are not `known`, which a newer or another program may have added.
    void noteUnknown(const JsonValue &object, std::span<const std::string_view> known) const;
    void noteUnknown(const JsonValue &object, std::initializer_list<std::string_view> known) const {
        noteUnknown(object, std::span(known.begin(), known.size()));
    }
    /// Records a fault for each member of an object, here or at any depth, whose name stands in it before. Readers of
    /// JSON disagree on which of them counts.
    void refuseRepeats(const JsonValue &value);
    /// Returns true once the list of faults is full.
    bool full() const { return faults_.size() >= kMaxListedFaults; }

    /// Returns the member, or records that it is missing.
    std::optional<JsonValue> member(const JsonValue &object, std::string_view name, std::string_view of);
    /// Returns true if the value is of that kind, or records a fault.
    bool expect(const JsonValue &value, JsonKind kind, std::string_view what);

    double number(const JsonValue &value, std::string_view what);
    /// Reads a number > 0.
    double positive(const JsonValue &value, std::string_view what);
    double notNegative(const JsonValue &value, std::string_view what);
    std::int64_t integer(const JsonValue &value, std::int64_t minimum, std::int64_t maximum, std::string_view what);
    std::int32_t tag(const JsonValue &value);
    bool flag(const JsonValue &value, std::string_view what);
    std::string string(const JsonValue &value, std::string_view what);
    /// Reads an array of exactly two numbers.
    Vec2 point(const JsonValue &value, std::string_view what);
    /// Reads a list of points.
    std::vector<Vec2> points(const JsonValue &list, std::string_view what);
    /// Returns the index of one of `words`.
    std::size_t choice(const JsonValue &value, std::span<const std::string_view> words, std::string_view what);

  private:
    const SourceText &source_;
    Diagnostics faults_;
};

} // namespace forefront
