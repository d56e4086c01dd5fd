#include "tests/support/png_sample.hpp"

#include <algorithm>
#include <cstddef>
#include <zlib.h>

namespace forefront::testing {

namespace {

std::string fourBytes(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes += static_cast<char>(value >> shift & 0xFFU);
    }
    return bytes;
}

} // namespace

std::uint32_t pngSum(std::string_view bytes) {
    return static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef *>(bytes.data()), static_cast<uInt>(bytes.size())));
}

std::string pngChunk(std::string_view kind, std::string_view content) {
    const std::string body = std::string(kind).append(content);
    return fourBytes(static_cast<std::uint32_t>(content.size())) + body + fourBytes(pngSum(body));
}

std::string storedStream(const std::vector<std::uint8_t> &bytes) {
    constexpr std::size_t kBlock = 65535;
    std::string stream = "\x78\x01";
    for (std::size_t at = 0; at < bytes.size() || at == 0; at += kBlock) {
        const std::size_t size = std::min(kBlock, bytes.size() - at);
        stream += at + size == bytes.size() ? '\1' : '\0';
        for (const std::size_t number : {size, ~size}) {
            stream += static_cast<char>(number & 0xFFU);
            stream += static_cast<char>(number >> 8 & 0xFFU);
        }
        stream.append(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                      bytes.begin() + static_cast<std::ptrdiff_t>(at + size));
    }
    return stream + fourBytes(static_cast<std::uint32_t>(adler32(1, bytes.data(), static_cast<uInt>(bytes.size()))));
}

std::string pngFile(const PngSample &sample, const std::string &data) {
    std::string head = fourBytes(sample.columns) + fourBytes(sample.rows);
    for (const unsigned byte : {sample.depth, sample.colour, 0U, 0U, sample.interlaced ? 1U : 0U}) {
        head += static_cast<char>(byte);
    }
    std::string file = std::string("\x89PNG\r\n\x1a\n", 8) + pngChunk("IHDR", head);
    file += sample.palette.empty() ? std::string() : pngChunk("PLTE", sample.palette);
    file += sample.transparency.empty() ? std::string() : pngChunk("tRNS", sample.transparency);
    const std::size_t cut = data.size() / 2;
    return file + pngChunk("IDAT", data.substr(0, cut)) + pngChunk("IDAT", data.substr(cut)) +
           pngChunk("tEXt", "a note") + pngChunk("IEND", {});
}

std::string pngFile(const PngSample &sample) {
    return pngFile(sample, storedStream(sample.bytes));
}

std::string greyPng(unsigned columns, unsigned rows, const std::vector<std::uint8_t> &greys) {
    PngSample sample{.columns = columns, .rows = rows};
    for (unsigned row = 0; row < rows; ++row) {
        sample.bytes.push_back(0);
        const auto begin = greys.begin() + static_cast<std::ptrdiff_t>(row * columns);
        sample.bytes.insert(sample.bytes.end(), begin, begin + static_cast<std::ptrdiff_t>(columns));
    }
    return pngFile(sample);
}

} // namespace forefront::testing
