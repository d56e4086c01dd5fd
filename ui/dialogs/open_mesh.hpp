#pragma once

#include "core/base/diagnostic.hpp"

#include <filesystem>

namespace forefront {

struct Shell;

/// Asks for the file of a mesh and opens it.
void openMesh(Shell &context);

/// Opens a mesh of any format to inspect its quality, asking about unsaved changes first: the mesh is shown as it is,
/// and its outline becomes the drawing. Returns the faults of a file that cannot be read.
Diagnostics openMesh(Shell &context, const std::filesystem::path &file);

/// Asks for a mesh file and shows it beside the mesh on the canvas, with a table of their figures.
void compareMesh(Shell &context);

/// Shows the mesh of a file beside the mesh on the canvas. Returns the faults of a file that cannot be read.
Diagnostics compareMesh(Shell &context, const std::filesystem::path &file);

} // namespace forefront
