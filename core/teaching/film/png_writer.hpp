#pragma once

#include "core/teaching/film/film_picture.hpp"

#include <string>

namespace forefront {

/// Returns a picture as a PNG file with the film's palette.
std::string pngOf(const FilmPicture &picture);

} // namespace forefront
