#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace forefront {

/// A KML text without three-dimensional models within geometries.
struct KmlWithoutModels {
    std::string text;
    std::size_t models = 0; ///< that were left out; 0: the text is empty, use the given one
};

/// Leaves out the elements Model within elements MultiGeometry: GDAL's driver LIBKML (3.6) reads beyond its memory on
/// them. Models elsewhere, which it skips, and texts that are not XML stay.
KmlWithoutModels withoutModels(std::string_view kml);

} // namespace forefront
