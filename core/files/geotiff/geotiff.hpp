#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/spacing/spec/raster.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"
#include "core/files/source/source.hpp"

#include <string_view>

namespace forefront {

/// Returns true if the first bytes of a file show that it is TIFF, or BigTIFF.
bool looksLikeTiff(std::string_view head);

/// Reads the first band of a GeoTIFF file, such as elevations, in the reference system of ImportOptions::projection if
/// one is given. Cells with the file's value for "none", or masked, have no value. Faults: missing-component; gdal,
/// with the text of GDAL; no-values.
Result<Raster> readGeoTiffRaster(const SourceText &source);
/// Reads it as sizes, as readEsriGrid() does. Faults also: bad-values (a size that is not above 0).
Result<SpacingSpec> readGeoTiffSpacing(const SourceText &source);

} // namespace forefront
