#include "core/drawing_files/geojson/local_projection.hpp"

#include "core/files/source/map_system.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace forefront {

namespace {

double radians(double degrees) {
    return degrees * (std::numbers::pi / 180.0);
}

} // namespace

LocalProjection::LocalProjection(Vec2 centre)
    : longitude_(radians(centre.x)), sinLatitude_(std::sin(radians(centre.y))),
      cosLatitude_(std::cos(radians(centre.y))) {}

Vec2 LocalProjection::operator()(Vec2 degrees) const {
    const double east = radians(degrees.x) - longitude_, latitude = radians(degrees.y);
    const double sine = std::sin(latitude), cosine = std::cos(latitude);
    // The point of the unit sphere: to the east and north of the centre, and along the axis through it.
    const Vec2 across{cosine * std::sin(east), cosLatitude_ * sine - sinLatitude_ * cosine * std::cos(east)};
    const double along = sinLatitude_ * sine + cosLatitude_ * cosine * std::cos(east);
    const double distance = std::hypot(across.x, across.y);
    const double angle = std::atan2(distance, along); // exact where the arc cosine of `along` is not
    return distance > 0.0 ? (kEarthRadius * angle / distance) * across : Vec2{0.0, 0.0};
}

double LocalProjection::stretch(Vec2 place) {
    const double angle = std::hypot(place.x, place.y) / kEarthRadius;
    if (angle <= 0.0) {
        return 1.0;
    }
    return angle < std::numbers::pi ? angle / std::sin(angle) : std::numeric_limits<double>::infinity();
}

} // namespace forefront
