#pragma once

#include <filesystem>

namespace forefront {

struct Shell;

/// Asks for the file of a mesh and opens it. The dialog stays open while it is read, and shows why it cannot be.
void openMesh(Shell &context);

/// Opens a mesh of any format to inspect its quality: the mesh is shown unchanged, and its outline becomes the drawing.
/// It is read as the background task of the shell, which then asks about unsaved changes. Faults are logged.
void openMesh(Shell &context, const std::filesystem::path &file);

/// Asks for a mesh file and shows it beside the mesh on the canvas, with a table of their figures.
void compareMesh(Shell &context);

/// Shows the mesh of a file beside the mesh on the canvas, once the background task of the shell has read it. Faults
/// are logged.
void compareMesh(Shell &context, const std::filesystem::path &file);

} // namespace forefront
