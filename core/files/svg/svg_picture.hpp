#pragma once

#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/source/export_options.hpp"
#include "core/files/text/text_writer.hpp"

namespace forefront {

/// Writes a drawing of the mesh: the elements of a region, or the edges of a boundary tag, are one path named by its
/// title, or several if there are many.
void writeSvg(const MeshView &mesh, TextWriter &out);
/// Writes the same with a size in ExportOptions::unit: inches for inches and feet, else millimetres.
void writeSvgWith(const MeshView &mesh, const ExportOptions &options, TextWriter &out);

} // namespace forefront
