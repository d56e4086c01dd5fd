#pragma once

#include "core/teaching/film/film_scene.hpp"

namespace forefront {

/// Returns the number of lines of the legend of labelled moments on a sheet of a width in pixels.
int legendLines(int width);
/// Adds the legend to a scene: each colour of a labelled moment names what it means. `top`: where its first line
/// begins, in pixels.
void addLegend(double top, FilmScene &scene);

} // namespace forefront
