#include "core/files/text/base64.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace forefront {

namespace {

constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t kNoDigit = 0xff;

constexpr std::array<std::uint8_t, 256> kValues = [] {
    std::array<std::uint8_t, 256> values{};
    values.fill(kNoDigit);
    for (std::size_t k = 0; k < kDigits.size(); ++k) {
        values[static_cast<unsigned char>(kDigits[k])] = static_cast<std::uint8_t>(k);
    }
    return values;
}();

} // namespace

std::string toBase64(std::string_view bytes) {
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        std::uint32_t group = 0;
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
        for (std::size_t k = 0; k < 3; ++k) {
            group = (group << 8) | (k < count ? static_cast<unsigned char>(bytes[at + k]) : 0U);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += k <= count ? kDigits[(group >> (18 - 6 * k)) & 63U] : '=';
        }
    }
    return text;
}

namespace {

/// Decodes whole groups of four digits from `text` on, up to the first other character. Returns the number of digits.
std::size_t decodeGroups(std::string_view text, char *bytes) {
    const auto value = [&](std::size_t at) -> std::uint32_t { return kValues[static_cast<unsigned char>(text[at])]; };
    std::size_t at = 0;
    for (; at + 4 <= text.size(); at += 4, bytes += 3) {
        const std::uint32_t a = value(at), b = value(at + 1), c = value(at + 2), d = value(at + 3);
        if (std::max({a, b, c, d}) == kNoDigit) {
            break;
        }
        const std::uint32_t group = (a << 18) | (b << 12) | (c << 6) | d;
        bytes[0] = static_cast<char>(group >> 16);
        bytes[1] = static_cast<char>((group >> 8) & 255U);
        bytes[2] = static_cast<char>(group & 255U);
    }
    return at;
}

} // namespace

std::optional<std::string> fromBase64(std::string_view text) {
    std::string bytes(text.size() / 4 * 3 + 3, '\0');
    std::size_t size = 0;
    std::uint32_t group = 0;
    std::size_t digits = 0;
    std::size_t padding = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (digits % 4 == 0 && padding == 0) {
            const std::size_t whole = decodeGroups(text.substr(at), bytes.data() + size);
            at += whole;
            digits += whole;
            size += whole / 4 * 3;
        }
        if (at == text.size()) {
            break;
        }
        const char c = text[at];
        if (c == ' ' || c == '\n' || c == '\r' || c == '\t') {
            continue;
        }
        if (c == '=') {
            ++padding;
            continue;
        }
        const std::uint8_t value = kValues[static_cast<unsigned char>(c)];
        if (value == kNoDigit || padding > 0) {
            return std::nullopt;
        }
        group = (group << 6) | value;
        if (++digits % 4 == 0) {
            bytes[size++] = static_cast<char>(group >> 16);
            bytes[size++] = static_cast<char>((group >> 8) & 255U);
            bytes[size++] = static_cast<char>(group & 255U);
        }
    }
    const std::size_t rest = digits % 4;
    if (rest == 1 || padding != (4 - rest) % 4) {
        return std::nullopt;
    }
    if (rest >= 2) {
        group <<= 6 * (4 - rest);
        bytes[size++] = static_cast<char>((group >> 16) & 255U);
        if (rest == 3) {
            bytes[size++] = static_cast<char>((group >> 8) & 255U);
        }
    }
    bytes.resize(size);
    return bytes;
}

} // namespace forefront
