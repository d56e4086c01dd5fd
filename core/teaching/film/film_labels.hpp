#pragma once

#include "core/engine/mesher/trace.hpp"
#include "core/teaching/film/film_scene.hpp"
#include "core/teaching/moment/moment.hpp"

#include <functional>

namespace forefront {

/// Adds the labels of an advance to a scene: A, B and C, each alone in its text, and the rank of each
/// candidate with its score or, of a square, what it does and why it is refused. Labels are kept apart and inside the
/// drawing, whose lower edge is `bottom`, in pixels. `at`: maps the plane to pixels.
void addLabels(const Moment &moment, const std::function<Vec2(Vec2)> &at, double bottom, FilmScene &scene);

} // namespace forefront
