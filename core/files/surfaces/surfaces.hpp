#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/text/text_writer.hpp"

namespace forefront {

/// Writes a polygon file (PLY), ASCII: faces with their region as the property `region`.
void writePly(const MeshView &mesh, TextWriter &out);
/// Writes triangles of stereolithography (STL), ASCII: a solid for each region, in the plane z = 0.
void writeStl(const MeshView &mesh, TextWriter &out);
/// Returns a note on the names of regions that STL changes.
Diagnostics noteStlChanges(const MeshView &mesh);
/// Writes an object file of Geomview (OFF).
void writeOff(const MeshView &mesh, TextWriter &out);

} // namespace forefront
