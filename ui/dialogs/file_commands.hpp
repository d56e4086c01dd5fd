#pragma once

#include "core/edit/document.hpp"

#include <filesystem>
#include <functional>

namespace forefront {

struct AppContext;

// The commands of the File menu. They report faults in the log.

/// Runs `then` after asking whether to save unsaved changes.
void afterUnsaved(AppContext &context, std::function<void(AppContext &)> then);
void newDocument(AppContext &context);
/// Opens the file dialog.
void openDocument(AppContext &context);
/// Opens a file, asking about unsaved changes first.
void openDocument(AppContext &context, const std::filesystem::path &file);
/// Saves the document to its file, or asks for one. Runs `then` once it is saved.
void saveDocument(AppContext &context, std::function<void(AppContext &)> then = {});
void saveDocumentAs(AppContext &context, std::function<void(AppContext &)> then = {});
/// Adds the drawing of a file to the current one.
void importDrawing(AppContext &context);
/// Imports the spacing of a project or of a mesh with nodal values.
void importSpacing(AppContext &context);
/// Exports the mesh in a format that the user chooses.
void exportMesh(AppContext &context);
/// Adds a file to the recent files.
void rememberFile(AppContext &context, const std::filesystem::path &file);

} // namespace forefront
