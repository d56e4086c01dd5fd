#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/vec2.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace FOREFRONT_API forefront {

/// Values of any sign on a regular grid, such as depths. Between the centres of four cells a value is bilinear; in the
/// outer halves of the outer cells it is that of the nearest centres.
struct Raster {
    Vec2 origin;                       ///< centre of the lower left cell
    Vec2 pitch{1.0, 1.0};              ///< width and height of a cell, > 0
    std::size_t columns = 0, rows = 0; ///< number of cells in each direction, > 0
    std::vector<double> values;        ///< row by row from the bottom, each from the left; NaN: none

    /// Returns the value at a place; NaN outside the cells, and where a cell that counts has none.
    double at(Vec2 place) const;
    /// Returns the change of the value per unit of length along x and y; NaN where at() is.
    Vec2 gradient(Vec2 place) const;

    /// Missing values are equal to each other.
    friend bool operator==(const Raster &a, const Raster &b);
};

/// Rasters by the names that expressions call them by.
using RasterMap = std::map<std::string, std::shared_ptr<const Raster>, std::less<>>;
/// Returns true if both have the same names with equal rasters.
bool sameRasters(const RasterMap &a, const RasterMap &b);

} // namespace forefront
