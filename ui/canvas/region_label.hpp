#pragma once

#include "core/drawing/picking/face_map.hpp"
#include "ui/canvas/canvas_painter.hpp"

#include <string_view>
#include <vector>

namespace forefront {

/// Returns the offsets from a region marker at which its label can stand, the best one first: where the label lies
/// inside the face. `faces` may be null.
std::vector<Pixel> regionLabelOffsets(const CanvasPainter &painter, const FaceMap *faces, Vec2 marker,
                                      std::string_view name, ImFont *font);

} // namespace forefront
