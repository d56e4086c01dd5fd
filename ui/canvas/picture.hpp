#pragma once

#include "core/engine/base/result.hpp"
#include "core/files/source/file_stamp.hpp"
#include "ui/input/pixels.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

namespace forefront {

/// A decoded picture.
struct Picture {
    std::filesystem::path file;
    FileStamp stamp;                ///< of the file before it was read
    PixelSize size;                 ///< in the file
    int columns = 0, rows = 0;      ///< of `rgba`: fewer than in the file if that is large
    std::vector<std::uint8_t> rgba; ///< row by row from the top
};

/// Maximum number of pixels in the file of a picture.
inline constexpr double kMaxPicturePixels = 100e6;

/// Returns true if the file name has the extension of a readable picture format.
bool isPictureName(const std::filesystem::path &file);
/// Returns the size of a PNG or JPEG file, from its header. Faults: "missing-picture", also for pipes and devices;
/// "bad-picture", "large-picture".
Result<PixelSize> readPictureSize(const std::filesystem::path &file);
/// Reads a PNG or JPEG file. Faults as for readPictureSize(). May be called on any thread.
Result<std::shared_ptr<const Picture>> readPicture(const std::filesystem::path &file);
/// Decodes the bytes of a PNG or JPEG file; null if they are damaged or memory is short. May be called on any thread.
std::shared_ptr<const Picture> decodePicture(std::string_view bytes);

} // namespace forefront
