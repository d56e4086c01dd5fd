#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace forefront::testing {

/// What a PNG file is made of.
struct PngSample {
    unsigned columns = 1, rows = 1;
    unsigned depth = 8, colour = 0;
    bool interlaced = false;
    std::vector<std::uint8_t> bytes{}; ///< the rows with their filters, before compression
    std::string palette{}, transparency{};
};

/// Returns the check sum of the kind and content of a chunk.
std::uint32_t pngSum(std::string_view bytes);
/// Returns a chunk of a PNG file with its length and check sum.
std::string pngChunk(std::string_view kind, std::string_view content);
/// Returns bytes as a zlib stream that is not compressed.
std::string storedStream(const std::vector<std::uint8_t> &bytes);
/// Returns a PNG file with this compressed data, by default the bytes of the sample.
std::string pngFile(const PngSample &sample, const std::string &data);
std::string pngFile(const PngSample &sample);
/// Returns a PNG file of 8-bit grey values, row by row from the top.
std::string greyPng(unsigned columns, unsigned rows, const std::vector<std::uint8_t> &greys);

} // namespace forefront::testing
