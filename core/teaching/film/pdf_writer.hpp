#pragma once

#include "core/teaching/film/film_scene.hpp"

#include <string>

namespace forefront {

/// Returns a scene as a PDF file of one page, 0.75 points per pixel. Texts stay text, in Helvetica and Symbol, which
/// every reader of PDF has; a character that neither has becomes a question mark.
std::string pdfOf(const FilmScene &scene);

} // namespace forefront
