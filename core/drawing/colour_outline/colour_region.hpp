#pragma once

#include "core/engine/base/progress.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// The pixels of a picture: red, green, blue and alpha, row by row from the top. Transparent ones lie on white.
struct PixelView {
    std::span<const std::uint8_t> rgba; ///< 4·columns·rows numbers
    int columns = 0, rows = 0;
};

/// A pixel of a picture.
struct PixelPlace {
    int column = 0; ///< from the left
    int row = 0;    ///< from the top

    friend bool operator==(const PixelPlace &, const PixelPlace &) = default;
};

/// Connected pixels of similar colour.
struct ColourRegion {
    int columns = 0, rows = 0;        ///< of the picture
    std::vector<std::uint8_t> inside; ///< per pixel of the picture, row by row from the top: 1 or 0
    std::size_t count = 0;            ///< pixels inside

    bool has(int column, int row) const {
        return column >= 0 && row >= 0 && column < columns && row < rows &&
               inside[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(column)] != 0;
    }
};

/// Returns the pixels that are connected to `seed` by their sides through pixels whose colour is within `tolerance`
/// (>= 0) of the one there: a distance in CIELAB for daylight D65, ΔE of 1976, where 2 is just visible and black and
/// white are 100 apart. The colour at the seed is the mean of the 5 x 5 pixels around it that are within the tolerance
/// of it, so that the grain of a photograph does not decide. The seed must be in the picture. Empty if cancelled.
ColourRegion floodByColour(const PixelView &picture, PixelPlace seed, double tolerance, const Progress &progress = {});

} // namespace forefront
