#include "core/files/png/png_pixels.hpp"

#include "core/files/png/png_pass.hpp"

#include <cstddef>

namespace forefront {

std::optional<std::vector<std::uint8_t>> coloursOf(PngDecoder &decoder) {
    const std::size_t columns = decoder.columns(), channels = decoder.channels(), bytes = decoder.sampleBytes();
    const bool coloured = channels >= 3, hasOpacity = channels % 2 == 0;
    std::vector<std::uint8_t> colours(4 * columns * decoder.rows()), row(columns * channels * bytes);
    for (int number = 0; number < decoder.passes(); ++number) {
        const PngPass pass(decoder, number);
        for (std::size_t j = 0; j < pass.rows; ++j) {
            if (!decoder.readRow(row.data(), pass.columns)) {
                return std::nullopt;
            }
            for (std::size_t k = 0; k < pass.columns; ++k) {
                const std::uint8_t *const from = row.data() + k * channels * bytes;
                std::uint8_t *const to = &colours[4 * ((pass.y + j * pass.stepY) * columns + pass.x + k * pass.stepX)];
                for (std::size_t c = 0; c < 3; ++c) {
                    to[c] = from[coloured ? c * bytes : 0];
                }
                to[3] = hasOpacity ? from[(channels - 1) * bytes] : 255;
            }
        }
    }
    return decoder.finish() ? std::optional(std::move(colours)) : std::nullopt;
}

} // namespace forefront
