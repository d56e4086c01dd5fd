#pragma once

#include "core/engine/base/vec2.hpp"
#include "core/engine/geometry/unit_vector.hpp"

namespace forefront {

/// An affine map of the plane: p becomes p.x·u + p.y·v + shift.
struct PlaneMap {
    Vec2 u{1.0, 0.0}; ///< image of the unit vector along x
    Vec2 v{0.0, 1.0}; ///< image of the unit vector along y
    Vec2 shift;       ///< image of the origin

    static PlaneMap translation(Vec2 by) { return {{1.0, 0.0}, {0.0, 1.0}, by}; }
    /// Rotation about a point by an angle in degrees, counter-clockwise; exact for multiples of 90.
    static PlaneMap rotation(double degrees, Vec2 about);
    /// Scaling along x and y, with a point that stays; a negative factor mirrors.
    static PlaneMap scaling(Vec2 factors, Vec2 about);
    /// Mirror image in the line through a point at an angle to the x axis, in degrees.
    static PlaneMap reflection(double degrees, Vec2 through);

    Vec2 operator()(Vec2 p) const { return p.x * u + p.y * v + shift; }
    /// Returns the map that applies `first`, then this one.
    PlaneMap after(const PlaneMap &first) const;
    double determinant() const { return cross(u, v); }
    bool isTranslation() const { return u == Vec2{1.0, 0.0} && v == Vec2{0.0, 1.0}; }
    /// Returns true if circles stay circles.
    bool isSimilarity() const;
    /// Returns true if lines along x stay along x or become lines along y.
    bool keepsAxes() const { return (u.y == 0.0 && v.x == 0.0) || (u.x == 0.0 && v.y == 0.0); }
    bool finite() const { return isFinite(u) && isFinite(v) && isFinite(shift); }
};

} // namespace forefront
