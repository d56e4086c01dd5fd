#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/common/mesh_field.hpp"
#include "core/files/source/source.hpp"
#include "core/files/text/text_writer.hpp"

#include <string_view>

namespace forefront {

/// Reads a two-dimensional mesh of SMS (.2dm), as BASEMENT, TUFLOW and QGIS use it, too. Every fault carries its place
/// in the source.
Result<Mesh> readTwoDm(const SourceText &source);
/// Reads it with the elevations of its nodes as values "elevation", unless all are 0.
Result<MeshFields> readTwoDmFields(const SourceText &source);
/// Returns true if the first bytes of a file show that it is of this format.
bool looksLikeTwoDm(std::string_view head);
/// Writes a two-dimensional mesh of SMS.
void writeTwoDm(const MeshView &mesh, TextWriter &out);
/// Returns a note that all nodes get the elevation 0, if the mesh has none.
Diagnostics noteTwoDmChanges(const MeshView &mesh);

} // namespace forefront
