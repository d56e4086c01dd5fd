#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/source/export_options.hpp"
#include "core/files/text/text_writer.hpp"

namespace forefront {

/// Writes a grid of ADCIRC (fort.14): land is of type 20, islands of type 21.
void writeAdcirc(const MeshView &mesh, const ExportOptions &options, TextWriter &out);
/// Writes a grid of SCHISM (hgrid.gr3): land is of type 0, islands of type 1.
void writeSchism(const MeshView &mesh, const ExportOptions &options, TextWriter &out);
/// Returns a note that all depths are 0.
Diagnostics noteDepths(const MeshView &mesh);

} // namespace forefront
