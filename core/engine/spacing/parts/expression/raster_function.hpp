#pragma once

#include "core/engine/spacing/parts/expression/plane_function.hpp"
#include "core/engine/spacing/spec/raster.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace forefront {

/// Maximum distance from cells with values, in cells, at which a raster may be used in an expression. Rasters of depths
/// end at the shore that the domain follows, some cells before or behind it.
inline constexpr std::uint32_t kMaxRasterReach = 2;

/// A raster without gaps. Missing cells have the mean of their neighbours that are nearer to cells with values; beyond
/// the cells, the value at the nearest place of the grid counts.
struct FilledRaster {
    Raster raster;                    ///< all values are finite
    std::vector<std::uint32_t> rings; ///< distance of each cell from those with values, in cells; 0: it has one
    std::string name;                 ///< for messages

    /// Fills a raster with at least one value. Takes time proportional to the number of cells.
    FilledRaster(const Raster &given, std::string rasterName);
    /// Returns the nearest place of the grid.
    Vec2 clamped(Vec2 p) const;
    Box2 box() const;
};

/// What a raster function gives.
enum class RasterValue : std::uint8_t {
    Value,
    AlongX, ///< change of the value per unit of length along x
    AlongY
};

/// A raster, or a component of its gradient, as a function of the position.
class RasterFunction final : public PlaneFunction {
  public:
    RasterFunction(std::shared_ptr<const FilledRaster> filled, RasterValue value)
        : filled_(std::move(filled)), value_(value) {}

    double at(Vec2 p) const override;
    ValueRange range(const Box2 &box) const override;
    /// Returns the fault raster-gap where the domain is farther than kMaxRasterReach from cells with values.
    Diagnostics gaps(const Domain &domain, const InsideTest *inside) const override;

  private:
    std::shared_ptr<const FilledRaster> filled_;
    RasterValue value_;
};

} // namespace forefront
