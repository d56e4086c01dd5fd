#pragma once

#include "core/teaching/film/film_scene.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace forefront {

/// A picture of palette colours.
struct FilmPicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> pixels; ///< indices into filmPalette(), row by row from the top

    const std::uint8_t *row(int y) const { return pixels.data() + static_cast<std::ptrdiff_t>(y) * width; }
};

/// Index that no picture uses; GIF frames use it to mark unchanged pixels.
inline constexpr std::uint8_t kUnchangedPixel = 255;

/// Draws a scene, antialiased.
FilmPicture paintScene(const FilmScene &scene);

/// Returns the 256 palette colours as red, green, blue triples.
std::vector<std::uint8_t> filmPalette();

} // namespace forefront
