#pragma once

#include "core/engine/base/result.hpp"
#include "ui/workspace/view/lesson_room.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace forefront {

struct Shell;

// The list of lessons. Faults of the lessons that come with the program go to the log.

/// Reads a lesson with its documents, which lie in its folder. Layers and panels must exist. `id`: of the entry;
/// `seed`: of its random numbers.
Result<LessonEntry> loadLesson(const Shell &context, const std::string &id, const std::filesystem::path &file,
                               std::uint64_t seed);
/// Reads the lessons that come with the program into the list, unless this was done before.
void listLessons(Shell &context);
/// Opens the lesson of a file as it is now, and adds it to the list; see openLesson().
Diagnostics openLessonFile(Shell &context, const std::filesystem::path &file);

} // namespace forefront
