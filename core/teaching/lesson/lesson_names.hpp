#pragma once

#include "core/teaching/lesson/lesson_read.hpp"

namespace forefront {

/// Returns the names of the editor's layers and panels, and of its widgets where all names of a group are known, for
/// programs that read lessons without a window. Documents are not read.
LessonNames editorNames();
/// Returns the widgets among them that are no layers, panels or tools: those of the timeline, the statistics and the
/// steps.
std::map<std::string, std::vector<std::string>> widgetNames();

} // namespace forefront
