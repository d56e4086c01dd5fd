#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/picking/face_map.hpp"

#include <cstdint>
#include <set>

namespace forefront {

/// Returns a drawing of faces of another one: each as closed shapes along its outline and its holes, with their
/// boundary tags, and the region markers in it. It has the names of `document`, and the sizes of these parts. `map`: of
/// its domain.
Document copyFaces(const Document &document, const FaceMap &map, const std::set<std::uint32_t> &faces);

} // namespace forefront
