#pragma once

#include "core/drawing/picking/face_map.hpp"
#include "ui/canvas/camera.hpp"
#include "ui/style/colour.hpp"

#include <span>
#include <vector>

namespace forefront {

/// How a face is tinted; opacities in [0, 1].
struct FaceTint {
    Colour colour;     ///< opaque
    double fill = 0.0; ///< opacity inside
    double rim = 0.0;  ///< additional opacity at the edges of the face, fading inwards

    bool visible() const { return fill > 0.0 || rim > 0.0; }
    friend bool operator==(const FaceTint &, const FaceTint &) = default;
};

/// Returns the tints of faces in the view of a camera, row by row from the bottom, with premultiplied opacities. Rims
/// are `rimWidth` pixels wide, 24 at most. Exact along x, sampled at the middle of each row along y.
std::vector<Colour> rasteriseFaces(const FaceMap &map, std::span<const FaceTint> tints, const Camera &camera,
                                   double rimWidth);

} // namespace forefront
