#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/vec2.hpp"

#include <optional>
#include <string>

namespace FOREFRONT_API forefront {

/// Mean radius of the Earth in metres: R1 of H. Moritz, Geodetic Reference System 1980.
inline constexpr double kEarthRadius = 6'371'008.7714;

/// The coordinate reference system of a mesh that was made from a map.
struct MapSystem {
    std::string code;        ///< such as "EPSG:3067"; empty: it has none, or none is known
    std::string wkt;         ///< well-known text, version 2, of the system with this code or name; empty: unknown
    bool geographic = false; ///< longitudes and latitudes in degrees
    /// Longitude and latitude in degrees of the centre of a local projection: azimuthal equidistant on the sphere with
    /// the mean radius of the Earth. Absent: there is no such projection.
    std::optional<Vec2> centre = {};

    /// Returns true if anything about the system is known.
    bool known() const { return !code.empty() || !wkt.empty() || geographic || centre; }
};

} // namespace forefront
