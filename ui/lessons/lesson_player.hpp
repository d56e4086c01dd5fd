#pragma once

#include "core/io/lesson/lesson_read.hpp"
#include "ui/workspace/lesson_room.hpp"

#include <cstddef>
#include <filesystem>

namespace forefront {

struct Shell;

// Lessons: their list, the page shown, and the answers. Faults of lesson files go to the log.

/// Reads a lesson with its documents, which lie in its folder. Layers and panels must exist.
Result<Lesson> loadLesson(const Shell &context, const std::filesystem::path &file);
/// Reads the lessons that come with the program into the list, unless this was done before.
void listLessons(Shell &context);

/// Opens a lesson at the page where it was left, after asking about unsaved changes.
void openLesson(Shell &context, const LessonEntry &entry);
/// Opens the lesson of a file, and adds it to the list.
Diagnostics openLessonFile(Shell &context, const std::filesystem::path &file);
/// Returns to the list of lessons. Layers, panels and tab are as before the lesson; the drawing stays.
void closeLesson(Shell &context);
/// Shows a page of the open lesson: its document, position, layers and camera.
void goToPage(Shell &context, std::size_t page);

/// Returns the state that the questions of the open lesson are about.
LessonState lessonState(const Shell &context);
/// Answers the question of the page by a choice.
void answerChoice(Shell &context, std::size_t choice);
/// Answers the question of the page by the number typed.
void answerNumber(Shell &context);
/// Moves the run to where the answer can be seen.
void showAnswer(Shell &context);
/// Checks whether the task of the page is done. Called once per frame.
void followLesson(Shell &context);

} // namespace forefront
