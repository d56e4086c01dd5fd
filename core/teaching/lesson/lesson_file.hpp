#pragma once

#include "core/teaching/lesson/lesson_read.hpp"

#include <filesystem>
#include <memory>
#include <string>

namespace forefront {

/// A lesson with the file that it was read from.
struct LessonFile {
    std::filesystem::path path;
    std::string text;
    Lesson lesson;

    /// Returns the text with its name, for the places of faults. It views this file.
    SourceText source() const;
    /// Reads the lesson with the random numbers of another seed; its drawings are those that this file has read.
    Result<Lesson> withSeed(std::uint64_t seed, LessonNames names) const;
};

/// Reads a lesson with its drawings and pictures, which lie in its folder or below it. `names`: without the readers of
/// documents and pictures. A picture that cannot be shown is no fault of the lesson, see pictureFaults().
/// Errors: cannot-read, too-large (a lesson is at most 4 MiB), those of readLesson().
Result<LessonFile> readLessonFile(const std::filesystem::path &path, LessonNames names);

} // namespace forefront
