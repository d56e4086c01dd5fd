#pragma once

#include "core/engine/base/vec2.hpp"

namespace forefront {

/// The azimuthal equidistant projection of the sphere: distances from the centre, and directions there, are true.
/// Follows J. P. Snyder, Map Projections: A Working Manual, U.S. Geological Survey Professional Paper 1395 (1987),
/// equations (22-4), (22-5), (25-2) and (5-3). The sphere has the mean radius of the Earth; since the Earth is
/// flattened, lengths are wrong by up to 0.6 %.
class LocalProjection {
  public:
    /// `centre`: longitude and latitude in degrees.
    explicit LocalProjection(Vec2 centre);

    /// Returns the place of a longitude and latitude in degrees: metres to the east and to the north of the centre.
    Vec2 operator()(Vec2 degrees) const;
    /// Returns the factor by which lengths across the direction of the centre are too long at a place in the plane; in
    /// that direction they are true. Infinite at the antipode.
    static double stretch(Vec2 place);

  private:
    double longitude_; ///< radians
    double sinLatitude_, cosLatitude_;
};

} // namespace forefront
