#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/files/common/domain_file.hpp"
#include "core/files/source/source.hpp"

#include <string_view>

namespace forefront {

/// Reads TopoJSON (version 1.0.0 of its specification, by M. Bostock and C. Metcalf) as a drawing in the plane, with
/// the same rules as GeoJSON. Of several layers ("objects"), which often cover each other, such as counties and states,
/// only one is read: ImportOptions::layer, or else the first one with polygons, or else the first; a note then names
/// the others.
Result<Domain> readTopoJson(const SourceText &source);
/// Reads it with the sizes of its areas and points, see ImportOptions::sizeProperty.
Result<DomainFile> readTopoJsonFile(const SourceText &source);
/// Returns true if the first bytes of a file show that it is TopoJSON.
bool looksLikeTopoJson(std::string_view head);

} // namespace forefront
