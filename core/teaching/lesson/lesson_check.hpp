#pragma once

#include "core/engine/base/progress.hpp"
#include "core/files/source/source.hpp"
#include "core/teaching/lesson/lesson.hpp"
#include "core/teaching/lesson/lesson_run.hpp"

namespace forefront {

/// Runs the drawings of a lesson and checks what only a run can tell: that each drawing can be meshed, that positions
/// and moments exist, that values in texts have a number, that each question has a right answer and that each task can
/// be done; and that its pictures can be shown. `source`: the file that the lesson was read from. Returns the faults
/// with their places in it, warnings among them: a question with right answers only, or a task that is done from the
/// start; "cancelled" alone if it was.
Diagnostics checkLesson(const Lesson &lesson, const SourceText &source, const Progress &progress);
/// Does the same, and leaves the runs for further use.
Diagnostics checkLesson(const Lesson &lesson, const SourceText &source, LessonRuns &runs, const Progress &progress);

} // namespace forefront
