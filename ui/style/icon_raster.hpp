#pragma once

#include "ui/style/icon_shapes.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// The part of an icon that is drawn: all of it, or only the squares that a user clicks, which an active tool shows in
/// another colour.
enum class IconPart : std::uint8_t { Whole, Nodes };

/// Returns the coverage of an icon, 0 to 255, in a picture of `size` x `size` pixels. It is computed from the distance
/// of each pixel to the shape, so that lines, their round ends and corners are smooth at every size. Dear ImGui's own
/// lines have neither round ends nor round corners.
std::vector<std::uint8_t> drawIcon(const IconShape &shape, IconPart part, int size);

} // namespace forefront
