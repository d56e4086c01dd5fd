#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/spacing/spec/raster.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"
#include "core/files/source/source.hpp"

#include <string_view>

namespace forefront {

/// Returns true if a file begins like an ESRI ASCII grid.
bool looksLikeEsriGrid(std::string_view head);

/// Reads an ESRI ASCII grid (.asc) of sizes as the spacing of a background mesh. A value holds at the centre of its
/// cell; between the centres the spacing is linear, and constant in the outer halves of the outer cells. Cells with the
/// NODATA value have no spacing. The header has ncols, nrows, xllcorner and yllcorner or xllcenter and yllcenter, and
/// cellsize or dx and dy, in domain units; the rows run from top to bottom.
///
/// Errors: bad-number, bad-count, missing-field, duplicate-field, bad-values (a size that is not above 0), no-values
/// (no triangle has three values), too-large (see kMaxGridValues).
Result<SpacingSpec> readEsriGrid(const SourceText &source);

/// Reads an ESRI ASCII grid of values of any sign, such as elevations, none of them averaged. Errors as for
/// readEsriGrid(), and no-values if all cells have the NODATA value.
Result<Raster> readEsriRaster(const SourceText &source);

} // namespace forefront
