#pragma once

#include "core/engine/base/diagnostic.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace forefront {

/// Maximum size of a picture of a lesson and of all of them, in bytes, and of its sides in pixels.
inline constexpr std::size_t kMaxLessonPicture = std::size_t{2} << 20U;
inline constexpr std::size_t kMaxLessonPictures = std::size_t{16} << 20U;
inline constexpr int kMaxPictureSide = 4096;

/// The kinds of pictures that texts of lessons may show.
enum class LessonPictureKind : std::uint8_t { Png, Jpeg };

/// A picture that a text of a lesson shows.
struct LessonPicture {
    std::string bytes{}; ///< of its file
    LessonPictureKind kind = LessonPictureKind::Png;
    int columns = 0, rows = 0; ///< in pixels
    Diagnostics faults{};      ///< why it cannot be shown; empty: it can
    int line = 0, column = 0;  ///< of the text of the lesson that shows it first
    std::size_t page = 0;      ///< of that text
};

/// Returns the picture whose file has these bytes, by its header. Faults: "bad-picture", a file that is neither PNG nor
/// JPEG or is damaged; "large-picture".
LessonPicture lessonPictureOf(std::string bytes);
/// Decodes a picture that has its bytes; returns why it cannot be shown, or nothing. Only a PNG file is decoded.
Diagnostics damageOf(const LessonPicture &picture);
/// Reads a picture from its file, without decoding it. Faults: those of lessonPictureOf(), "missing-picture".
LessonPicture readLessonPicture(const std::filesystem::path &file);

} // namespace forefront
