#pragma once

#include "core/files/source/map_system.hpp"
#include "core/files/ugrid/classic_netcdf.hpp"

#include <string>

namespace forefront {

/// Returns the name of the variable that describes a reference system, as Delft3D FM calls it.
std::string systemVariable(const MapSystem &system);

/// Returns the variable that describes a known reference system: the attributes of a grid mapping of the CF
/// conventions (version 1.8, section 5.6 and appendix F), and those by which Delft3D FM and MDAL find the system.
NetcdfVariable systemOf(const MapSystem &system);

} // namespace forefront
