#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/source/export_options.hpp"
#include "core/files/text/text_writer.hpp"

namespace forefront {

/// Writes a mesh of first order as DXF of version R12, which all programs read: elements as 3DFACE, boundary parts as
/// polylines and points as POINT, each on the layer named after its region or tag.
void writeDxf(const MeshView &mesh, TextWriter &out);
/// Writes the tagged edges and points of a mesh alone. Edges along a circular arc become one segment with a bulge;
/// those along other curves, vertices within kDxfTolerance of the curve.
void writeDxfOutline(const MeshView &mesh, TextWriter &out);
/// Write the same with ExportOptions::unit.
void writeDxfWith(const MeshView &mesh, const ExportOptions &options, TextWriter &out);
void writeDxfOutlineWith(const MeshView &mesh, const ExportOptions &options, TextWriter &out);
/// Notes the names that are no names of layers.
Diagnostics noteDxfChanges(const MeshView &mesh);

/// The maximum distance of a polyline from the curve that it stands for, relative to the size of the mesh.
inline constexpr double kDxfTolerance = 1e-6;

} // namespace forefront
