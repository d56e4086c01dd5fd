#pragma once

#include <string_view>

namespace forefront {

/// The parts of the page that shows a lesson, as they are in lesson.html, lesson.css and lesson.js.
std::string_view lessonBody();
std::string_view lessonStyle();
std::string_view lessonScript();

} // namespace forefront
