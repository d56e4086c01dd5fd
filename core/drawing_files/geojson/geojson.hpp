#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/files/common/domain_file.hpp"
#include "core/files/source/source.hpp"

#include <string_view>

namespace forefront {

/// Reads GeoJSON (RFC 7946) as a drawing in the plane. Neighbouring polygons share interfaces; a polygon inside another
/// polygon is a separate region; lines and points are constraints. If the holes of a polygon do not lie in its outline,
/// its rings are parts and holes in any order, by the even-odd rule; a note reports this. The properties "tag" and a
/// name (see ImportOptions::nameProperty) of a feature apply to its boundary and region. The features may also be
/// separate texts, one a line or as a GeoJSON text sequence (RFC 8142).
Result<Domain> readGeoJson(const SourceText &source);
/// Reads it with the sizes of its areas and points, see ImportOptions::sizeProperty.
Result<DomainFile> readGeoJsonFile(const SourceText &source);
/// Returns true if the first bytes of a file show that it is GeoJSON; a project may begin with the same words.
bool looksLikeGeoJson(std::string_view head);

} // namespace forefront
