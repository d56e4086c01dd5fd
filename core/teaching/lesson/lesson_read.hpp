#pragma once

#include "core/engine/base/result.hpp"
#include "core/files/source/source.hpp"
#include "core/teaching/lesson/lesson.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// Version of the lesson files that this program reads.
inline constexpr int kLessonVersion = 1;

/// The names that a lesson may refer to.
struct LessonNames {
    std::vector<std::string> layers; ///< ids of layers; empty: any name is accepted
    std::vector<std::string> panels; ///< ids of panels; empty: any name is accepted
    /// Names of widgets, grouped by the prefix before their first '/'; with any other prefix, every name is accepted.
    std::map<std::string, std::vector<std::string>> widgets;
    /// Reads the document with this name, a path relative to the lesson; empty: documents are not read.
    std::function<Result<Document>(const std::string &name)> document;
    /// Reads the picture of this file, a path relative to the lesson; empty: pictures are not read.
    std::function<LessonPicture(const std::string &file)> picture{};
    /// Chooses the random numbers of the lesson; the same seed gives the same numbers.
    std::uint64_t seed = 1;
};

/// Reads a lesson, JSON as described in assets/lessons/README.md. Every fault carries its place in the source; unknown
/// members are faults, since they are usually misspelt.
Result<Lesson> readLesson(const SourceText &source, const LessonNames &names);

} // namespace forefront
