#include "core/drawing_files/project/tile_code.hpp"

#include "core/files/text/base64.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace forefront {

namespace {

constexpr std::size_t kLongestLiteral = 128;
constexpr std::size_t kLongestRun = 129;
constexpr std::size_t kRunBase = 126;

void appendWord(std::string &bytes, float value) {
    const auto word = std::bit_cast<std::uint32_t>(value);
    for (unsigned shift = 0; shift < 32; shift += 8) {
        bytes += static_cast<char>((word >> shift) & 255U);
    }
}

float wordAt(std::string_view bytes, std::size_t at) {
    std::uint32_t word = 0;
    for (unsigned k = 0; k < 4; ++k) {
        word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + k])) << (8 * k);
    }
    return std::bit_cast<float>(word);
}

/// Returns the number of equal words from `begin` on, at most kLongestRun.
std::size_t runLength(const PaintedSpacing::Tile &tile, std::size_t begin) {
    std::size_t end = begin + 1;
    while (end < tile.size() && end - begin < kLongestRun &&
           std::bit_cast<std::uint32_t>(tile[end]) == std::bit_cast<std::uint32_t>(tile[begin])) {
        ++end;
    }
    return end - begin;
}

} // namespace

std::string encodeTile(const PaintedSpacing::Tile &tile) {
    std::string bytes;
    for (std::size_t at = 0; at < tile.size();) {
        std::size_t run = runLength(tile, at);
        if (run > 1) {
            bytes += static_cast<char>(run + kRunBase);
            appendWord(bytes, tile[at]);
            at += run;
            continue;
        }
        std::size_t end = at;
        while (end < tile.size() && end - at < kLongestLiteral && runLength(tile, end) == 1) {
            ++end;
        }
        bytes += static_cast<char>(end - at - 1);
        for (; at < end; ++at) {
            appendWord(bytes, tile[at]);
        }
    }
    return toBase64(bytes);
}

std::optional<PaintedSpacing::Tile> decodeTile(std::string_view text) {
    constexpr std::size_t kLongestText = 4096;
    const auto bytes = text.size() <= kLongestText ? fromBase64(text) : std::nullopt;
    if (!bytes) {
        return std::nullopt;
    }
    PaintedSpacing::Tile tile{};
    std::size_t filled = 0;
    std::size_t at = 0;
    while (at < bytes->size()) {
        const auto control = static_cast<unsigned char>((*bytes)[at++]);
        const bool literal = control < kLongestLiteral;
        const std::size_t words = literal ? control + std::size_t{1} : control - kRunBase;
        if (filled + words > tile.size() || at + 4 * (literal ? words : 1) > bytes->size()) {
            return std::nullopt;
        }
        for (std::size_t k = 0; k < words; ++k) {
            tile[filled++] = wordAt(*bytes, at);
            at += literal ? 4 : 0;
        }
        at += literal ? 0 : 4;
    }
    return filled == tile.size() ? std::optional(tile) : std::nullopt;
}

} // namespace forefront
