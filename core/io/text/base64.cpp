#include "core/io/text/base64.hpp"

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

std::optional<std::string> fromBase64(std::string_view text) {
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3);
    std::uint32_t group = 0;
    std::size_t digits = 0;
    std::size_t padding = 0;
    for (const char c : text) {
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
            bytes += static_cast<char>(group >> 16);
            bytes += static_cast<char>((group >> 8) & 255U);
            bytes += static_cast<char>(group & 255U);
        }
    }
    const std::size_t rest = digits % 4;
    if (rest == 1 || padding != (4 - rest) % 4) {
        return std::nullopt;
    }
    if (rest >= 2) {
        group <<= 6 * (4 - rest);
        bytes += static_cast<char>((group >> 16) & 255U);
        if (rest == 3) {
            bytes += static_cast<char>((group >> 8) & 255U);
        }
    }
    return bytes;
}

} // namespace forefront
