#pragma once

#include "core/files/text/text_writer.hpp"
#include "core/teaching/lesson/lesson.hpp"
#include "core/teaching/lesson/lesson_run.hpp"

namespace forefront {

/// Writes the colours under the mesh of a page as an object that player.js draws, or null: those of the layer `quality`
/// if the page colours it by an expression, else ρ if it has the layer `size`. `shown`: the run at the position of the
/// page. Meshes of more than 3000 triangles, or of other elements, have none.
void writePageColours(TextWriter &out, const LessonPage &page, LessonRun &run, const SessionSnapshot &shown);

} // namespace forefront
