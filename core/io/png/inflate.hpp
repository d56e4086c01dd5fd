#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace forefront {

/// The greatest ratio by which deflate can compress: one match of 258 bytes in two bits.
inline constexpr std::size_t kMaxInflation = 1032;

/// Decompresses a zlib stream (RFC 1950) into exactly `bytes.size()` bytes. Returns what is wrong with it, or null. The
/// check sum of the content is not compared: the chunks of a PNG file have their own.
const char *inflate(std::string_view stream, std::vector<std::uint8_t> &bytes);

} // namespace forefront
