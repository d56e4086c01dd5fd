#pragma once

#include "core/engine/base/api.hpp"

#include <charconv>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

/// A destination of written bytes.
class ByteSink {
  public:
    virtual ~ByteSink() = default;
    /// Returns false if the bytes could not be written; the writer then stops.
    virtual bool write(std::string_view bytes) = 0;
};

class StringSink final : public ByteSink {
  public:
    bool write(std::string_view bytes) override {
        text.append(bytes);
        return true;
    }
    std::string text;
};

/// Writes buffered text to a sink. Doubles are written with the fewest digits that read back to the same bits.
class TextWriter {
  public:
    explicit TextWriter(ByteSink &sink) : sink_(sink), buffer_(kCapacity) {}
    TextWriter(const TextWriter &) = delete;
    TextWriter &operator=(const TextWriter &) = delete;

    TextWriter &operator<<(char c) {
        reserve(1);
        buffer_[used_++] = c;
        return *this;
    }
    TextWriter &operator<<(std::string_view text) {
        if (text.size() > kCapacity - kLongestNumber) {
            flush();
            ok_ = ok_ && sink_.write(text);
            return *this;
        }
        reserve(text.size());
        text.copy(buffer_.data() + used_, text.size()); // unlike memcpy, also for an empty text without data
        used_ += text.size();
        return *this;
    }
    TextWriter &operator<<(const char *text) { return *this << std::string_view(text); }
    template <std::integral Integer>
    TextWriter &operator<<(Integer value) {
        return number(value);
    }
    TextWriter &operator<<(double value) { return number(value); }
    TextWriter &operator<<(float value) { return number(value); }
    TextWriter &operator<<(bool) = delete;

    /// Writes raw bytes of a value or array in the byte order of the machine.
    TextWriter &bytes(const void *data, std::size_t size) {
        return *this << std::string_view(static_cast<const char *>(data), size);
    }

    /// Returns false once the sink has refused bytes; long loops should then end.
    bool ok() const { return ok_; }
    bool flush() {
        if (used_ > 0) {
            ok_ = ok_ && sink_.write({buffer_.data(), used_});
            used_ = 0;
        }
        return ok_;
    }

  private:
    static constexpr std::size_t kCapacity = std::size_t{1} << 18;
    static constexpr std::size_t kLongestNumber = 64;

    void reserve(std::size_t size) {
        if (kCapacity - used_ < size) {
            flush();
        }
    }
    template <class Number>
    TextWriter &number(Number value) {
        reserve(kLongestNumber);
        char *begin = buffer_.data() + used_;
        used_ += static_cast<std::size_t>(std::to_chars(begin, begin + kLongestNumber, value).ptr - begin);
        return *this;
    }

    ByteSink &sink_;
    std::vector<char> buffer_;
    std::size_t used_ = 0;
    bool ok_ = true;
};

} // namespace forefront
