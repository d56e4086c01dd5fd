#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/files/text/text_writer.hpp"
#include "core/teaching/lesson/lesson.hpp"
#include "core/teaching/lesson/lesson_run.hpp"

namespace forefront {

/// Writes a lesson as an HTML page with its questions and the runs that it shows. The page needs no network and nothing
/// beside it. It shows the mesh, the front, the candidates and the cells of the grid; other layers and the panels are
/// the editor's. A page or task that needs a step of the improvement says that the editor shows it. The lesson must be
/// free of the faults of checkLesson(). Faults: those of writeRunPage() for each run; those of the sink are its own.
/// Warnings: "not-on-page", a task that no moment of the page fulfils.
Status writeLessonPage(const Lesson &lesson, TextWriter &out, const Progress &progress);
/// Does the same with runs of its pages that are made already, which move.
Status writeLessonPage(const Lesson &lesson, LessonRuns &runs, TextWriter &out, const Progress &progress);

} // namespace forefront
