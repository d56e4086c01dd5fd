#include "core/io/film/png_writer.hpp"

#include "core/io/common/crc32.hpp"
#include "core/io/common/deflate_classes.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace forefront {

namespace {

constexpr std::size_t kLongestMatch = 258, kShortestMatch = 4, kWindow = 32768;

template <std::size_t N>
unsigned classOf(const std::array<DeflateClass, N> &classes, std::size_t value) {
    const auto next = std::upper_bound(classes.begin(), classes.end(), value,
                                       [](std::size_t v, const DeflateClass &range) { return v < range.first; });
    return static_cast<unsigned>(next - classes.begin()) - 1;
}

/// Compresses bytes as one deflate block with fixed codes. It looks for matches only one byte and one row back, where
/// drawings repeat.
class Deflater {
  public:
    Deflater(std::string_view bytes, std::size_t row) : bytes_(bytes), row_(row) {}

    std::string compress() {
        put(1, 1); // the last block
        put(1, 2); // with fixed codes
        for (std::size_t at = 0; at < bytes_.size();) {
            const std::size_t left = matchLength(at, 1), above = matchLength(at, row_);
            const std::size_t length = std::max(left, above);
            if (length < kShortestMatch) {
                literal(static_cast<std::uint8_t>(bytes_[at++]));
            } else {
                match(length, left >= above ? 1 : row_);
                at += length;
            }
        }
        symbol(256);
        put(0, 7); // flushes the last byte
        return std::move(result_);
    }

  private:
    std::size_t matchLength(std::size_t at, std::size_t distance) const {
        if (distance > at || distance > kWindow) {
            return 0;
        }
        std::size_t length = 0;
        const std::size_t most = std::min(kLongestMatch, bytes_.size() - at);
        while (length < most && bytes_[at + length] == bytes_[at + length - distance]) {
            ++length;
        }
        return length;
    }
    void put(unsigned value, unsigned count) {
        buffer_ |= value << bits_;
        for (bits_ += count; bits_ >= 8; bits_ -= 8) {
            result_ += static_cast<char>(buffer_ & 0xFFU);
            buffer_ >>= 8;
        }
    }
    /// Writes a code, most significant bit first.
    void code(unsigned value, unsigned count) {
        for (unsigned bit = count; bit-- > 0;) {
            put(value >> bit & 1U, 1);
        }
    }
    void symbol(unsigned value) {
        if (value < 144) {
            code(0x30 + value, 8);
        } else if (value < 256) {
            code(0x190 + value - 144, 9);
        } else if (value < 280) {
            code(value - 256, 7);
        } else {
            code(0xC0 + value - 280, 8);
        }
    }
    void literal(std::uint8_t value) { symbol(value); }
    void match(std::size_t length, std::size_t distance) {
        const unsigned ofLength = classOf(kDeflateLengths, length), ofDistance = classOf(kDeflateDistances, distance);
        symbol(257 + ofLength);
        put(static_cast<unsigned>(length) - kDeflateLengths[ofLength].first, kDeflateLengths[ofLength].extraBits);
        code(ofDistance, 5);
        put(static_cast<unsigned>(distance) - kDeflateDistances[ofDistance].first,
            kDeflateDistances[ofDistance].extraBits);
    }

    std::string_view bytes_;
    std::size_t row_;
    std::uint32_t buffer_ = 0;
    unsigned bits_ = 0;
    std::string result_;
};

/// Appends a number, most significant byte first.
void appendNumber(std::string &bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes += static_cast<char>(value >> shift & 0xFFU);
    }
}

std::uint32_t adler32(std::string_view bytes) {
    std::uint32_t a = 1, b = 0;
    for (const char byte : bytes) {
        a = (a + static_cast<std::uint8_t>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

void appendChunk(std::string &file, std::string_view kind, std::string_view content) {
    appendNumber(file, static_cast<std::uint32_t>(content.size()));
    const std::string body = std::string(kind).append(content);
    file += body;
    appendNumber(file, crc32(body));
}

} // namespace

std::string pngOf(const FilmPicture &picture) {
    std::string head, palette, rows;
    appendNumber(head, static_cast<std::uint32_t>(picture.width));
    appendNumber(head, static_cast<std::uint32_t>(picture.height));
    head += std::string_view("\x08\x03\0\0\0", 5); // 8-bit indices into a palette
    for (const std::uint8_t part : filmPalette()) {
        palette += static_cast<char>(part);
    }
    const auto width = static_cast<std::size_t>(picture.width);
    for (int y = 0; y < picture.height; ++y) {
        rows += '\0'; // no filter
        rows.append(reinterpret_cast<const char *>(picture.row(y)), width);
    }
    std::string data = "\x78\x01" + Deflater(rows, width + 1).compress();
    appendNumber(data, adler32(rows));
    std::string file = "\x89PNG\r\n\x1a\n";
    appendChunk(file, "IHDR", head);
    appendChunk(file, "PLTE", palette);
    appendChunk(file, "IDAT", data);
    appendChunk(file, "IEND", {});
    return file;
}

} // namespace forefront
