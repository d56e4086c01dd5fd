#pragma once

#include <glm/vec2.hpp>

#include <vector>

namespace forefront {

/// A polyline along a path of an icon. A closed one ends where it begins.
using IconLine = std::vector<glm::dvec2>;

/// Returns a path of SVG with the commands M, L, H, V, A, C and Z as polylines. Arcs become pieces
/// of an eighth of a radian.
std::vector<IconLine> flattenPath(const char *path);
/// Cuts lines into dashes.
std::vector<IconLine> dashesOf(const std::vector<IconLine> &lines, double dash, double gap);
/// Returns the numbers in a text, which spaces separate.
std::vector<double> numbersIn(const char *text);

} // namespace forefront
