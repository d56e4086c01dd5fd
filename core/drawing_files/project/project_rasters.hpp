#pragma once

#include "core/engine/spacing/spec/raster.hpp"
#include "core/files/json/json.hpp"
#include "core/files/json/json_check.hpp"

namespace forefront {

class JsonText;

/// Writes the rasters of a spacing as an object of objects by name; missing values are null.
void writeRasters(const RasterMap &rasters, JsonText &out);
/// Reads them. Faults: those of JsonCheck, bad-name, bad-count, no-values.
RasterMap readRasters(const JsonValue &object, JsonCheck &check);

} // namespace forefront
