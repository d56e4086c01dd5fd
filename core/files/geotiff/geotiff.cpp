#include "core/files/geotiff/geotiff.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/files/common/cell_grid.hpp"
#include "core/files/components/gdal_source.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace forefront {

namespace {

using namespace std::string_view_literals;

} // namespace

bool looksLikeTiff(std::string_view head) {
    return head.starts_with("II*\0"sv) || head.starts_with("MM\0*"sv) || head.starts_with("II+\0"sv) ||
           head.starts_with("MM\0+"sv);
}

Result<Raster> readGeoTiffRaster(const SourceText &source) {
    const Result<const GdalFunctions *> gdal = gdalComponent();
    if (!gdal) {
        return gdal.faults();
    }
    const GdalSource file(source, {"GTiff"});
    GdalRaster read;
    GdalReport report;
    if (!(*gdal)->readRaster(file.file, source.options.maxBytes / sizeof(double), read, report)) {
        return gdalFailure(report);
    }
    noteWarnings(report, source);
    DrawingContents contents;
    contents.system.code = read.systemCode;
    source.reportContents(contents);
    if (read.bands > 1) {
        source.note("raster-bands", "only the first of the " + std::to_string(read.bands) + " bands is read", 0);
    }
    if (std::none_of(read.values.begin(), read.values.end(), [](double value) { return std::isfinite(value); })) {
        return error("no-values", "the raster has no values");
    }
    Raster raster;
    raster.origin = {read.originX, read.originY};
    raster.pitch = {read.pitchX, read.pitchY};
    raster.columns = read.columns;
    raster.rows = read.rows;
    raster.values = std::move(read.values);
    return raster;
}

Result<SpacingSpec> readGeoTiffSpacing(const SourceText &source) {
    const Result<Raster> raster = readGeoTiffRaster(source);
    if (!raster) {
        return raster.faults();
    }
    const GridCounts counts = averagedCounts(raster->columns, raster->rows, kMaxGridValues);
    CellGrid grid;
    grid.columns = counts.columns;
    grid.rows = counts.rows;
    grid.low = raster->origin - 0.5 * raster->pitch;
    grid.step = {raster->pitch.x * static_cast<double>(raster->columns) / static_cast<double>(counts.columns),
                 raster->pitch.y * static_cast<double>(raster->rows) / static_cast<double>(counts.rows)};
    CellMeans means(raster->columns, raster->rows, grid);
    for (std::size_t k = 0; k < raster->values.size(); ++k) {
        const std::size_t row = raster->rows - 1 - k / raster->columns, column = k % raster->columns;
        const double value = raster->values[row * raster->columns + column];
        if (value <= 0.0) {
            Diagnostics faults =
                error("bad-values", "expected a size above 0, got " + numberText(value, 6),
                      "mark cells without a size with gdal_translate -a_nodata " + numberText(value, 6) + " FILE NEW");
            faults.front().at = raster->origin + Vec2{raster->pitch.x * static_cast<double>(column),
                                                      raster->pitch.y * static_cast<double>(row)};
            return faults;
        }
        means.add(k, std::isfinite(value) ? std::optional(value) : std::nullopt);
    }
    means.finish();
    noteAveraged(grid, raster->columns, raster->rows, source);
    return spacingOfGrid(grid, source);
}

} // namespace forefront
