#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/engine/geometry/unit_vector.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace FOREFRONT_API forefront {

/// A picture below the drawing, such as a scanned map, to be traced. It is not part of the domain. The document links
/// to the picture's file, which may be missing.
struct BackgroundPicture {
    std::string file;     ///< absolute path, UTF-8; project files store it relative to their folder
    Vec2 corner;          ///< the lower left one of the picture
    Vec2 size{1.0, 1.0};  ///< width and height, > 0
    double opacity = 0.6; ///< between 0 and 1
    bool locked = false;  ///< drawn, but neither moved nor scaled
    double angle = 0.0;   ///< of its lower edge to the x axis, in degrees, counter-clockwise

    friend bool operator==(const BackgroundPicture &, const BackgroundPicture &) = default;
};

/// Returns the vector from the lower left corner to the lower right one.
inline Vec2 lowerEdge(const BackgroundPicture &picture) {
    return picture.size.x * unitVector(picture.angle);
}
/// Returns the vector from the lower left corner to the upper left one.
inline Vec2 leftEdge(const BackgroundPicture &picture) {
    const Vec2 along = unitVector(picture.angle);
    return picture.size.y * Vec2{-along.y, along.x};
}

/// Returns the place of a point given as shares of the width and height, from the lower left corner.
inline Vec2 placeIn(const BackgroundPicture &picture, Vec2 share) {
    return picture.corner + share.x * lowerEdge(picture) + share.y * leftEdge(picture);
}
/// Returns the shares of the width and height of a place: between 0 and 1 in the picture.
inline Vec2 shareOf(const BackgroundPicture &picture, Vec2 place) {
    const Vec2 arm = place - picture.corner, along = lowerEdge(picture), up = leftEdge(picture);
    return {dot(arm, along) / lengthSquared(along), dot(arm, up) / lengthSquared(up)};
}
/// Returns true if a place is in the picture.
inline bool covers(const BackgroundPicture &picture, Vec2 place) {
    const Vec2 share = shareOf(picture, place);
    return share.x >= 0.0 && share.x <= 1.0 && share.y >= 0.0 && share.y <= 1.0;
}

/// Returns the corners of the picture, counter-clockwise from the lower left one.
inline std::array<Vec2, 4> cornersOf(const BackgroundPicture &picture) {
    return {picture.corner, placeIn(picture, {1.0, 0.0}), placeIn(picture, {1.0, 1.0}), placeIn(picture, {0.0, 1.0})};
}
/// Returns the smallest rectangle along the axes that contains the picture.
inline Box2 boundsOf(const BackgroundPicture &picture) {
    if (picture.angle == 0.0) { // exactly
        return {picture.corner, picture.corner + picture.size};
    }
    Box2 box;
    for (const Vec2 corner : cornersOf(picture)) {
        box.add(corner);
    }
    return box;
}

/// Scales a picture by `factor` and keeps the place `fixed` of it where it is.
inline BackgroundPicture scaledAbout(BackgroundPicture picture, Vec2 fixed, double factor) {
    picture.corner = fixed + factor * (picture.corner - fixed);
    picture.size = factor * picture.size;
    return picture;
}

/// Turns, scales and moves a picture so that two points of it, given as shares, which must differ, lie at two places.
inline BackgroundPicture placedBy(BackgroundPicture picture, Vec2 firstShare, Vec2 secondShare, Vec2 first,
                                  Vec2 second) {
    const Vec2 then = placeIn(picture, secondShare) - placeIn(picture, firstShare), now = second - first;
    const double factor = length(now) / length(then);
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    picture.size = factor * picture.size;
    picture.angle = std::remainder(picture.angle + kDegrees * std::atan2(cross(then, now), dot(then, now)), 360.0);
    picture.corner += first - placeIn(picture, firstShare);
    return picture;
}

} // namespace forefront
