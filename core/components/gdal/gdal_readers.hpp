#pragma once

#include "core/files/components/gdal_component.hpp"

namespace forefront::gdal {

/// See GdalFunctions::readMap.
bool readMap(const GdalFile &file, const std::optional<std::string> &layers, std::size_t maximum, GdalMap &map,
             GdalReport &report);
/// See GdalFunctions::readRaster.
bool readRaster(const GdalFile &file, std::size_t maximum, GdalRaster &raster, GdalReport &report);

} // namespace forefront::gdal
