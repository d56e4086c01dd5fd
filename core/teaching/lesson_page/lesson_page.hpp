#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/files/text/text_writer.hpp"
#include "core/teaching/lesson/lesson.hpp"

namespace forefront {

/// Writes a lesson as an HTML page with its questions and the runs that it shows. The page needs no network and nothing
/// beside it. It shows the mesh, the front, the candidates and the cells of the grid; other layers and the panels are
/// the editor's. The lesson must be free of the faults of checkLesson(). Faults: those of writeRunPage() for each run;
/// those of the sink are its own.
Status writeLessonPage(const Lesson &lesson, TextWriter &out, const Progress &progress);

} // namespace forefront
