#include "core/components/gdal/gdal_readers.hpp"
#include "core/components/gdal/gdal_session.hpp"

#include <array>
#include <cmath>
#include <cpl_conv.h>
#include <gdalwarper.h>
#include <limits>

namespace forefront::gdal {

namespace {

/// Returns a raster that is converted to another reference system while it is read; null, with a message, on failure.
Dataset converted(Session &session, GDALDatasetH set, const std::string &projection) {
    OGRSpatialReferenceH const own = GDALGetSpatialRef(set);
    const ReferenceSystem target = session.named(projection);
    if (target == nullptr) {
        return {};
    }
    char *from = nullptr, *to = nullptr;
    if (own == nullptr || OSRExportToWkt(own, &from) != OGRERR_NONE ||
        OSRExportToWkt(target.get(), &to) != OGRERR_NONE) {
        CPLFree(from);
        CPLFree(to);
        session.fail("the raster names no coordinate reference system to convert from",
                     "name it, for example with gdal_translate -a_srs EPSG:n FILE NEW");
        return {};
    }
    Dataset warped(GDALAutoCreateWarpedVRT(set, from, to, GRA_Bilinear, 0.0, nullptr));
    CPLFree(from);
    CPLFree(to);
    if (warped == nullptr) {
        session.fail("the raster cannot be converted to " + projection);
    }
    return warped;
}

/// Reads the cells from the lowest row up; those without a value become NaN.
bool readCells(Session &session, GDALRasterBandH band, GdalRaster &raster) {
    int hasNoData = 0, hasScale = 0, hasOffset = 0;
    const double noData = GDALGetRasterNoDataValue(band, &hasNoData);
    const double scale = GDALGetRasterScale(band, &hasScale), offset = GDALGetRasterOffset(band, &hasOffset);
    GDALRasterBandH const mask = GDALGetMaskBand(band);
    const bool masked = (GDALGetMaskFlags(band) & GMF_ALL_VALID) == 0;
    const auto width = static_cast<int>(raster.columns);
    std::vector<unsigned char> valid(raster.columns, 1);
    raster.values.resize(raster.columns * raster.rows);
    for (std::size_t k = 0; k < raster.rows; ++k) {
        double *const row = raster.values.data() + k * raster.columns;
        const auto line = static_cast<int>(raster.rows - 1 - k);
        if (GDALRasterIO(band, GF_Read, 0, line, width, 1, row, width, 1, GDT_Float64, 0, 0) != CE_None ||
            (masked &&
             GDALRasterIO(mask, GF_Read, 0, line, width, 1, valid.data(), width, 1, GDT_Byte, 0, 0) != CE_None)) {
            return session.fail("cannot read line " + std::to_string(line) + " of the raster");
        }
        for (std::size_t c = 0; c < raster.columns; ++c) {
            const bool none = valid[c] == 0 || !std::isfinite(row[c]) || (hasNoData != 0 && row[c] == noData);
            row[c] = none ? std::numeric_limits<double>::quiet_NaN()
                          : row[c] * (hasScale != 0 ? scale : 1.0) + (hasOffset != 0 ? offset : 0.0);
        }
    }
    return true;
}

} // namespace

bool readRaster(const GdalFile &file, std::size_t maximum, GdalRaster &raster, GdalReport &report) {
    Session session(report);
    const Dataset opened = session.open(file, GDAL_OF_RASTER);
    Dataset warped;
    if (opened != nullptr && !file.projection.empty()) {
        warped = converted(session, opened.get(), file.projection);
    }
    GDALDatasetH const set = file.projection.empty() ? opened.get() : warped.get();
    if (set == nullptr) {
        return false;
    }
    std::array<double, 6> grid{}; // x = grid[0] + column·grid[1] + row·grid[2], likewise y with the other three
    if (GDALGetGeoTransform(set, grid.data()) != CE_None) {
        return session.fail("the raster is not placed in the plane", "give it a place with gdal_translate -a_ullr");
    }
    if (grid[2] != 0.0 || grid[4] != 0.0 || !(std::fabs(grid[1]) > 0.0) || !(std::fabs(grid[5]) > 0.0) ||
        !std::isfinite(grid[0] + grid[1] + grid[3] + grid[5]) || grid[1] < 0.0 || grid[5] > 0.0) {
        return session.fail("the rows of the raster do not run from west to east, the first in the north",
                            "straighten it with gdalwarp FILE NEW");
    }
    OGRSpatialReferenceH const system = GDALGetSpatialRef(set);
    const char *const authority = system != nullptr ? OSRGetAuthorityName(system, nullptr) : nullptr;
    const char *const code = system != nullptr ? OSRGetAuthorityCode(system, nullptr) : nullptr;
    raster.systemCode = authority != nullptr && code != nullptr ? std::string(authority) + ':' + code : std::string();
    raster.columns = static_cast<std::size_t>(GDALGetRasterXSize(set));
    raster.rows = static_cast<std::size_t>(GDALGetRasterYSize(set));
    raster.bands = static_cast<std::size_t>(GDALGetRasterCount(set));
    if (raster.bands == 0 || raster.columns == 0 || raster.rows == 0) {
        return session.fail("the raster has no cells");
    }
    if (raster.columns > maximum / raster.rows) {
        return session.fail("the raster has " + std::to_string(raster.columns) + " x " + std::to_string(raster.rows) +
                                " cells; at most " + std::to_string(maximum) + " can be read",
                            "make it coarser with gdalwarp -tr DX DY -r average FILE NEW, or cut it with -te");
    }
    raster.pitchX = grid[1];
    raster.pitchY = -grid[5];
    raster.originX = grid[0] + 0.5 * raster.pitchX;
    raster.originY = grid[3] - (static_cast<double>(raster.rows) - 0.5) * raster.pitchY;
    return readCells(session, GDALGetRasterBand(set, 1), raster);
}

} // namespace forefront::gdal
