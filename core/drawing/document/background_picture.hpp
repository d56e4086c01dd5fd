#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/vec2.hpp"

#include <string>

namespace FOREFRONT_API forefront {

/// A picture below the drawing, such as a scanned map, to be traced. It is not part of the domain. The document links
/// to the picture's file, which may be missing.
struct BackgroundPicture {
    std::string file;     ///< absolute path, UTF-8; project files store it relative to their folder
    Vec2 corner;          ///< the lower left one
    Vec2 size{1.0, 1.0};  ///< width and height, > 0
    double opacity = 0.6; ///< between 0 and 1
    bool locked = false;  ///< drawn, but neither moved nor scaled

    friend bool operator==(const BackgroundPicture &, const BackgroundPicture &) = default;
};

/// Returns the rectangle that a picture covers.
inline Box2 boundsOf(const BackgroundPicture &picture) {
    return {picture.corner, picture.corner + picture.size};
}

/// Scales a picture by `factor` and keeps the place `fixed` of it where it is.
inline BackgroundPicture scaledAbout(BackgroundPicture picture, Vec2 fixed, double factor) {
    picture.corner = fixed + factor * (picture.corner - fixed);
    picture.size = factor * picture.size;
    return picture;
}

} // namespace forefront
