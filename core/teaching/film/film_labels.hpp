#pragma once

#include "core/engine/mesher/trace.hpp"
#include "core/teaching/film/film_scene.hpp"
#include "core/teaching/moment/moment.hpp"

#include <functional>

namespace forefront {

/// Adds the labels of an advance to a scene: A, B and C, each alone in its text, and the rank of each candidate with
/// its score or, of a square, what it does, and with its verdict. Labels are kept apart, inside the drawing, whose
/// lower edge is `bottom`, in pixels, and clear of the lines of the scene where there is room; a line leads from a
/// label to a point that is not beside it. `at`: maps the plane to pixels.
void addLabels(const Moment &moment, const std::function<Vec2(Vec2)> &at, double bottom, FilmScene &scene);

} // namespace forefront
