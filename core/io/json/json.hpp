#pragma once

#include "core/base/result.hpp"
#include "core/io/source/source.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

enum class JsonKind : std::uint8_t { Null, False, True, Number, String, Array, Object };

/// A parsed JSON text as a flat tape of 16 bytes a value, in the order of the text. Every value knows its byte, so that
/// a fault found later still has line and column; numbers and strings are decoded when asked for. The text must outlive
/// it.
class JsonDocument {
  public:
    struct Entry {
        std::size_t offset = 0;
        std::uint32_t next = 0; ///< entry after this value and all it contains
        JsonKind kind = JsonKind::Null;
    };

    /// Faults: json-syntax, too-deep (more than 64 levels), too-large (more than 2^32 bytes), each located.
    static Result<JsonDocument> parse(const SourceText &source);

    class JsonValue root() const;

  private:
    friend class JsonValue;
    friend class JsonParser;
    std::string_view text_;
    std::vector<Entry> tape_;
};

/// A handle to one value of a document; cheap to copy.
class JsonValue {
  public:
    /// Walks the items of an array, or the members of an object.
    class Iterator {
      public:
        Iterator(const JsonDocument *document, std::uint32_t index, bool keyed)
            : document_(document), index_(index), keyed_(keyed) {}
        JsonValue operator*() const { return {document_, keyed_ ? index_ + 1 : index_}; }
        /// Name of the member.
        std::string key() const { return JsonValue(document_, index_).string(); }
        JsonValue keyValue() const { return {document_, index_}; }
        Iterator &operator++() {
            index_ = document_->tape_[keyed_ ? index_ + 1 : index_].next;
            return *this;
        }
        friend bool operator==(const Iterator &a, const Iterator &b) { return a.index_ == b.index_; }

      private:
        const JsonDocument *document_;
        std::uint32_t index_;
        bool keyed_;
    };

    JsonValue(const JsonDocument *document, std::uint32_t index) : document_(document), index_(index) {}

    JsonKind kind() const { return entry().kind; }
    bool is(JsonKind kind) const { return entry().kind == kind; }
    /// Byte of the text where the value begins.
    std::size_t offset() const { return entry().offset; }
    Iterator begin() const { return {document_, index_ + 1, is(JsonKind::Object)}; }
    /// Values without content are empty ranges.
    Iterator end() const { return {document_, entry().next, is(JsonKind::Object)}; }
    std::size_t count() const;
    /// First member of that name, or nothing (also when this is no object).
    std::optional<JsonValue> find(std::string_view name) const;

    /// The number, or nothing when it is none or beyond the range of a double.
    std::optional<double> number() const;
    /// The number where it is written as an integer within [-2^63, 2^63).
    std::optional<std::int64_t> integer() const;
    /// The decoded string; empty when it is none.
    std::string string() const;

  private:
    const JsonDocument::Entry &entry() const { return document_->tape_[index_]; }

    const JsonDocument *document_;
    std::uint32_t index_;
};

inline JsonValue JsonDocument::root() const {
    return {this, 0};
}

/// "text" with quotes and escapes, as JSON wants it.
std::string jsonString(std::string_view text);

} // namespace forefront
