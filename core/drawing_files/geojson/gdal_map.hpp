#pragma once

#include "core/engine/base/result.hpp"
#include "core/files/common/domain_file.hpp"
#include "core/files/source/source.hpp"

#include <string_view>

namespace forefront {

/// Read the maps that the component forefront-gdal reads, as GeoJSON of the same features would be: the first layer
/// with areas, or those that ImportOptions::layer names, in the reference system of ImportOptions::projection if one is
/// given. Faults also: missing-component; gdal, with the text of GDAL.
Result<DomainFile> readShapefile(const SourceText &source);
Result<DomainFile> readGeoPackage(const SourceText &source);
Result<DomainFile> readKml(const SourceText &source);
Result<DomainFile> readFlatGeobuf(const SourceText &source);
/// Read GeoJSON and TopoJSON; with GDAL only where they are to be converted to another reference system.
Result<DomainFile> readGeoJsonMap(const SourceText &source);
Result<DomainFile> readTopoJsonMap(const SourceText &source);

/// Return true if the first bytes of a file show that it is of the format.
bool looksLikeShapefile(std::string_view head);
bool looksLikeGeoPackage(std::string_view head);
bool looksLikeKml(std::string_view head);
bool looksLikeFlatGeobuf(std::string_view head);

} // namespace forefront
