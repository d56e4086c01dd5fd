#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"
#include "core/files/source/picture_sizes.hpp"
#include "core/files/source/source.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace forefront {

/// The grey values of a picture, each the mean over a rectangle of pixels.
struct GreyPicture {
    std::size_t pixelColumns = 0, pixelRows = 0; ///< of the file
    std::size_t columns = 0, rows = 0;           ///< of the values
    std::vector<double> values;                  ///< row by row from the top; 0: black, 1: white, kNoGrey: transparent
};
inline constexpr double kNoGrey = -1.0;

/// Returns true if a file begins like a PNG file.
bool looksLikePng(std::string_view head);

/// Reads the grey values of a PNG file of any kind: colours become their luminance (Rec. 709, of the stored values),
/// and where more than half the pixels of a value are fully transparent, there is none. Faults:
/// bad-picture, large-picture (more than 100 million pixels), cancelled.
Result<GreyPicture> readGreyPicture(const SourceText &source, std::size_t most);

/// Returns the grey values of a picture as the spacing of a background mesh (see spacingOfGrid()). Notes if the picture
/// has more pixels than values. Faults: bad-size, bad-box, no-values.
Result<SpacingSpec> spacingOfPicture(const GreyPicture &picture, const PictureSizes &sizes, const SourceText &source);

/// Reads a PNG file as spacing, with at most kMaxGridValues sizes, by ImportOptions::picture. Further faults: those of
/// readGreyPicture(); missing-sizes (the options have none).
Result<SpacingSpec> readPngSpacing(const SourceText &source);

} // namespace forefront
