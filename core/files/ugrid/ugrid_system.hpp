#pragma once

#include "core/engine/base/length_unit.hpp"
#include "core/files/source/map_system.hpp"
#include "core/files/ugrid/classic_netcdf.hpp"

#include <string>

namespace forefront {

/// Returns the name of the variable that describes a reference system, as Delft3D FM calls it.
std::string systemVariable(const MapSystem &system);

/// Returns the unit of projected coordinates in the words of UDUNITS: `unit`, or else that of the axes of the system,
/// else metres.
std::string projectedUnit(LengthUnit unit, const MapSystem &system);

/// Returns the variable that describes a known reference system: the attributes of a grid mapping of the CF
/// conventions (version 1.8, section 5.6 and appendix F), and those by which Delft3D FM and MDAL find the system.
NetcdfVariable systemOf(const MapSystem &system);

} // namespace forefront
