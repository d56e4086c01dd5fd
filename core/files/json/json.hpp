#pragma once

#include "core/engine/base/result.hpp"
#include "core/files/source/source.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

enum class JsonKind : std::uint8_t { Null, False, True, Number, String, Array, Object };

/// A parsed JSON text as a flat tape of 16 bytes per value, in the order of the text. Every value keeps its byte
/// offset, so that a fault found later still has a line and column; numbers and strings are decoded on demand. The text
/// must outlive it.
///
/// Compared with simdjson's on-demand parser (Debian's 3.0.1) on a GeoJSON file of 70 MB with 4 million coordinates:
/// 0.27 s of CPU time for parsing and decoding here, 0.10 s there (-O2, minimum of five runs). Reading the file into a
/// domain takes 4.1 s, of which the library could save 4 %. The tape is kept for what it offers: the whole text is
/// validated before any of it is used, whereas on-demand parsing accepts malformed text in members that nobody visits;
/// members can be looked up in any order and visited again, as readers do that report all faults of a file at once; and
/// values keep their places after parsing.
class JsonDocument {
  public:
    struct Entry {
        std::size_t offset = 0;
        std::uint32_t next = 0; ///< entry after this value and all it contains
        JsonKind kind = JsonKind::Null;
    };

    /// Parses a JSON text. Faults: json-syntax, too-deep (more than 64 levels), too-large (more than 2^32 bytes), each
    /// located.
    static Result<JsonDocument> parse(const SourceText &source);
    /// Parses one JSON text after the other, divided by blanks or by the record separators of RFC 8142, into an array;
    /// after the first one, each must be an object. Faults: the same.
    static Result<JsonDocument> parseSequence(const SourceText &source);

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
        /// Returns the name of the member.
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
    /// Returns the byte of the text where the value begins.
    std::size_t offset() const { return entry().offset; }
    /// Iterates over items or members; values without content are empty ranges.
    Iterator begin() const { return {document_, index_ + 1, is(JsonKind::Object)}; }
    Iterator end() const { return {document_, entry().next, is(JsonKind::Object)}; }
    std::size_t count() const;
    /// Returns the first member of that name; std::nullopt if there is none or this is not an object.
    std::optional<JsonValue> find(std::string_view name) const;

    /// Returns the number; std::nullopt if this is not one or it is beyond the range of a double.
    std::optional<double> number() const;
    /// Returns the number if it is written as an integer within [-2^63, 2^63).
    std::optional<std::int64_t> integer() const;
    /// Returns the decoded string; empty if this is not one.
    std::string string() const;
    /// Returns the text of a number; empty if this is not a number.
    std::string_view numeral() const;

  private:
    const JsonDocument::Entry &entry() const { return document_->tape_[index_]; }

    const JsonDocument *document_;
    std::uint32_t index_;
};

inline JsonValue JsonDocument::root() const {
    return {this, 0};
}

/// Returns the text as a JSON string, with quotes and escapes.
std::string jsonString(std::string_view text);

} // namespace forefront
