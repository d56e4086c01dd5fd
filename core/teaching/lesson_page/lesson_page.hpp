#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/files/text/text_writer.hpp"
#include "core/teaching/lesson/lesson.hpp"
#include "core/teaching/lesson/lesson_run.hpp"

#include <cstddef>

namespace forefront {

/// Writes a lesson as an HTML page with its questions and the runs that it shows. The page needs no network and nothing
/// beside it. It shows the mesh, the front, the candidates and the cells of the grid; other layers and the panels are
/// the editor's. Of a long improvement the page has only the first steps, and a page or task that needs another says
/// that the editor shows it. The lesson must be free of the faults of checkLesson(). Faults: those of writeRunPage()
/// for each run; those of the sink are its own. Warnings: "not-on-page", a task that no moment of the page fulfils.
Status writeLessonPage(const Lesson &lesson, TextWriter &out, const Progress &progress);
/// Does the same with runs of its pages that are made already, which move. `maxImproveBytes`: of the steps of the
/// improvement of all runs, which share it equally; less if the page is long.
Status writeLessonPage(const Lesson &lesson, LessonRuns &runs, TextWriter &out, const Progress &progress,
                       std::size_t maxImproveBytes = 200'000);

} // namespace forefront
