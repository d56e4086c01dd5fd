#include "core/io/film/png_writer.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>

namespace forefront {

namespace {

constexpr std::size_t kLongestMatch = 258, kShortestMatch = 4, kWindow = 32768;

/// A length or distance class of deflate (RFC 1951, 3.2.5): its first value and the number of extra bits.
struct Range {
    unsigned first, extra;
};
constexpr Range kLengths[] = {{3, 0},   {4, 0},   {5, 0},   {6, 0},   {7, 0},  {8, 0},  {9, 0},  {10, 0},
                              {11, 1},  {13, 1},  {15, 1},  {17, 1},  {19, 2}, {23, 2}, {27, 2}, {31, 2},
                              {35, 3},  {43, 3},  {51, 3},  {59, 3},  {67, 4}, {83, 4}, {99, 4}, {115, 4},
                              {131, 5}, {163, 5}, {195, 5}, {227, 5}, {258, 0}};
constexpr Range kDistances[] = {{1, 0},     {2, 0},     {3, 0},     {4, 0},      {5, 1},      {7, 1},
                                {9, 2},     {13, 2},    {17, 3},    {25, 3},     {33, 4},     {49, 4},
                                {65, 5},    {97, 5},    {129, 6},   {193, 6},    {257, 7},    {385, 7},
                                {513, 8},   {769, 8},   {1025, 9},  {1537, 9},   {2049, 10},  {3073, 10},
                                {4097, 11}, {6145, 11}, {8193, 12}, {12289, 12}, {16385, 13}, {24577, 13}};

template <std::size_t N>
unsigned classOf(const Range (&ranges)[N], std::size_t value) {
    const auto *const next = std::upper_bound(std::begin(ranges), std::end(ranges), value,
                                              [](std::size_t v, const Range &range) { return v < range.first; });
    return static_cast<unsigned>(next - std::begin(ranges)) - 1;
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
        const unsigned ofLength = classOf(kLengths, length), ofDistance = classOf(kDistances, distance);
        symbol(257 + ofLength);
        put(static_cast<unsigned>(length) - kLengths[ofLength].first, kLengths[ofLength].extra);
        code(ofDistance, 5);
        put(static_cast<unsigned>(distance) - kDistances[ofDistance].first, kDistances[ofDistance].extra);
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

std::uint32_t crc32(std::string_view bytes) {
    static const std::array<std::uint32_t, 256> table = [] {
        std::array<std::uint32_t, 256> made{};
        for (std::uint32_t k = 0; k < 256; ++k) {
            std::uint32_t value = k;
            for (int bit = 0; bit < 8; ++bit) {
                value = (value & 1U) != 0 ? 0xEDB88320U ^ value >> 1 : value >> 1;
            }
            made[k] = value;
        }
        return made;
    }();
    std::uint32_t sum = 0xFFFFFFFFU;
    for (const char byte : bytes) {
        sum = table[(sum ^ static_cast<std::uint8_t>(byte)) & 0xFFU] ^ sum >> 8;
    }
    return ~sum;
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
