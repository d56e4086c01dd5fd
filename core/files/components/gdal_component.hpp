#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/base/vec2.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// A file for GDAL.
struct GdalFile {
    std::string path;                   ///< empty: it is in memory
    const std::string *bytes = nullptr; ///< of a file in memory
    std::vector<const char *> drivers;  ///< GDAL's names of the formats that it may have
    std::string projection;             ///< reference system to convert to, such as "EPSG:3067"; empty: its own
    std::vector<Vec2> places = {};      ///< to convert with the first layer of a map
};

/// The features of a map as GeoJSON, with a member "crs" where the reference system is known.
struct GdalMap {
    std::string geoJson;
    std::vector<std::string> layers; ///< all that have geometries
    std::vector<std::string> read;   ///< those that were read
    std::vector<Vec2> places;        ///< GdalFile::places, converted
    std::string systemCode;          ///< of the reference system of the text, such as "EPSG:3067"; empty: none
    std::string systemWkt;           ///< its well-known text, version 2; empty: unknown
};

/// The first band of a raster.
struct GdalRaster {
    double originX = 0.0, originY = 0.0; ///< centre of the lower left cell
    double pitchX = 1.0, pitchY = 1.0;   ///< > 0
    std::size_t columns = 0, rows = 0;
    std::vector<double> values; ///< row by row from the bottom, each from the left; NaN: none
    std::size_t bands = 1;
    std::string systemCode; ///< of its reference system, such as "EPSG:3067"; empty: it names none
};

/// What went wrong, and the warnings of GDAL.
struct GdalReport {
    std::string message, advice;
    std::vector<std::string> warnings;
};

/// The functions of the component that reads maps and rasters with GDAL. They return false with a message on failure.
struct GdalFunctions {
    /// Reads layers of a map: those in `layers`, one name or several with commas between them; else the first with
    /// areas, or else the first. Fails where the text would have more than `maximum` bytes.
    bool (*readMap)(const GdalFile &file, const std::optional<std::string> &layers, std::size_t maximum, GdalMap &map,
                    GdalReport &report);
    /// Reads a raster with at most `maximum` cells.
    bool (*readRaster)(const GdalFile &file, std::size_t maximum, GdalRaster &raster, GdalReport &report);
};

/// Returns the component, which is loaded once. Fault: missing-component.
Result<const GdalFunctions *> gdalComponent();

} // namespace forefront
