#pragma once

#include "core/film/film_scene.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace forefront {

/// A picture of palette colours.
struct FilmPicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> pixels; ///< an index into filmPalette() for each, row by row from the top

    const std::uint8_t *row(int y) const { return pixels.data() + static_cast<std::ptrdiff_t>(y) * width; }
};

/// Index that no picture uses; GIF frames mark with it the pixels that stay as they were.
inline constexpr std::uint8_t kUnchangedPixel = 255;

/// Draws a scene, antialiased.
FilmPicture paintScene(const FilmScene &scene);

/// Returns the 256 colours of pictures, red, green and blue of each.
std::vector<std::uint8_t> filmPalette();

} // namespace forefront
