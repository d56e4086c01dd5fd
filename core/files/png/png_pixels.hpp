#pragma once

#include "core/files/png/png_decoder.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace forefront {

/// Returns the colours and opacities of an opened PNG file, 4 bytes a pixel, row by row from the top; of samples of 16
/// bits the higher 8. Empty if the file is damaged; the decoder has the fault. Throws std::bad_alloc.
std::optional<std::vector<std::uint8_t>> coloursOf(PngDecoder &decoder);

} // namespace forefront
