#pragma once

#include "core/files/text/text_scanner.hpp"

#include <bit>
#include <cstring>
#include <string>

namespace forefront {

/// Reads little-endian numbers between the words of a text. Failures are recorded in the text scanner; counts are
/// checked against the bytes left. When destroyed, the text scanner continues after the last number read.
class ByteScanner {
  public:
    static_assert(std::endian::native == std::endian::little, "numbers are read in the byte order of the machine");

    /// Starts at the byte after the line end that follows the last word; bytes may look like blanks.
    explicit ByteScanner(TextScanner &text) : text_(text), bytes_(text.source().text), at_(text.offset()) {
        at_ += bytes_.substr(at_).starts_with('\n') ? 1 : 0;
    }
    ~ByteScanner() { text_.seek(at_); }
    ByteScanner(const ByteScanner &) = delete;
    ByteScanner &operator=(const ByteScanner &) = delete;

    std::size_t offset() const { return at_; }
    std::size_t remaining() const { return bytes_.size() - at_; }
    bool fail(std::size_t offset, const char *code, const std::string &message) {
        return text_.fail(offset, code, message);
    }

    template <class T>
    bool number(T &value, Expect expect) {
        const char *const place = block(1, sizeof(T), expect);
        if (place != nullptr) {
            std::memcpy(&value, place, sizeof(T));
        }
        return place != nullptr;
    }
    /// Reads a 32-bit integer within bounds.
    bool integer(std::int32_t &value, std::int32_t minimum, std::int32_t maximum, Expect expect) {
        const std::size_t place = at_;
        if (!number(value, expect)) {
            return false;
        }
        return (value >= minimum && value <= maximum) ||
               fail(place, "out-of-range",
                    "expected an integer from " + std::to_string(minimum) + " to " + std::to_string(maximum) + " for " +
                        expect.words() + ", found " + std::to_string(value));
    }
    /// Reads a 64-bit number of items that follow, each at least `size` bytes long.
    bool count(std::size_t &value, std::size_t size, Expect expect) {
        const std::size_t place = at_;
        std::uint64_t items = 0;
        if (!number(items, expect)) {
            return false;
        }
        value = static_cast<std::size_t>(items);
        return items <= remaining() / size ||
               text_.fail(place, "bad-count",
                          expect.words() + " is given as " + std::to_string(items) + ", but only " +
                              std::to_string(remaining()) + " bytes follow",
                          "the file may have been cut short");
    }
    /// Skips `items` times `size` bytes and returns where they begin; null when there are fewer.
    const char *block(std::size_t items, std::size_t size, Expect expect) {
        if (!text_.ok()) {
            return nullptr;
        }
        if (items > remaining() / size) {
            text_.fail(at_, "bad-syntax", "the file ends within " + expect.words(), "the file may have been cut short");
            return nullptr;
        }
        const char *const begin = bytes_.data() + at_;
        at_ += items * size;
        return begin;
    }

  private:
    TextScanner &text_;
    std::string_view bytes_;
    std::size_t at_;
};

/// Returns number k of an array in a file, which need not be aligned.
template <class T>
T numberAt(const char *array, std::size_t k) {
    T value;
    std::memcpy(&value, array + k * sizeof(T), sizeof(T));
    return value;
}

} // namespace forefront
