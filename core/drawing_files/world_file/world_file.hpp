#pragma once

#include "core/drawing/document/background_picture.hpp"
#include "core/engine/base/result.hpp"

#include <filesystem>
#include <string_view>
#include <vector>

namespace forefront {

/// The place of a picture in the plane, as a world file gives it.
struct PicturePlace {
    Vec2 corner;        ///< lower left corner of the picture
    Vec2 size;          ///< width and height, > 0
    double angle = 0.0; ///< of its lower edge, see BackgroundPicture
};

/// Reads the text of an ESRI world file: six numbers, one a line, which map the middles of pixels to the plane: x per
/// column, y per column, x per row, y per row, x and y of the upper left pixel. `columns`, `rows`: of the picture in
/// its file. Faults: bad-world-file for a text that is no such list, for a picture that it mirrors or shears, and for
/// one without an area.
Result<PicturePlace> parseWorldFile(std::string_view text, int columns, int rows, const std::filesystem::path &file);

/// Returns the names that the world file of a picture may have, the most specific first: for map.png map.pgw, map.pngw
/// and map.wld; the same in capitals.
std::vector<std::filesystem::path> worldFileNames(const std::filesystem::path &picture);

} // namespace forefront
