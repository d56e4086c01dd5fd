#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/text/text_writer.hpp"

namespace forefront {

// The elevations of nodes are z; without elevations the surface lies in the plane z = 0.

/// Writes a polygon file (PLY), ASCII: faces with their region as the property `region`.
void writePly(const MeshView &mesh, TextWriter &out);
/// Writes triangles of stereolithography (STL), ASCII: a solid for each region.
void writeStl(const MeshView &mesh, TextWriter &out);
/// Returns a note that z is 0 at all nodes, if the mesh has no elevations.
Diagnostics noteFlatSurface(const MeshView &mesh);
/// Returns it with a note on the names of regions that STL changes.
Diagnostics noteStlChanges(const MeshView &mesh);
/// Writes an object file of Geomview (OFF).
void writeOff(const MeshView &mesh, TextWriter &out);

} // namespace forefront
