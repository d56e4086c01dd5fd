#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/vec2.hpp"

namespace FOREFRONT_API forefront {

/// The linear map from the grey values of a picture to element sizes, given by the sizes of black and white.
struct PictureSizes {
    double black = 0.0; ///< size where the picture is black, > 0
    double white = 0.0; ///< size where it is white, > 0
    Box2 box{};         ///< rectangle of the picture, in domain units
    /// True: the picture keeps its proportions and covers the box (see pictureBoxAround()). False: it fills the box.
    bool around = false;

    friend bool operator==(const PictureSizes &, const PictureSizes &) = default;
};

/// Returns the smallest rectangle with the proportions of `columns` x `rows` pixels around the middle of a box that
/// covers the box. A box without width or height gets a rectangle of height 1.
Box2 pictureBoxAround(const Box2 &box, double columns, double rows);

} // namespace forefront
