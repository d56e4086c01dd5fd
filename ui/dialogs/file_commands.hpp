#pragma once

#include "core/edit/document.hpp"

#include <filesystem>
#include <functional>

namespace forefront {

struct AppContext;

/// What the File menu does. Faults go to the log.

/// Does `then`, after asking what shall become of unsaved changes.
void afterUnsaved(AppContext &context, std::function<void(AppContext &)> then);
void newDocument(AppContext &context);
/// Opens the file dialog.
void openDocument(AppContext &context);
/// Opens a file, asking about unsaved changes first.
void openDocument(AppContext &context, const std::filesystem::path &file);
/// Saves where the document is saved, else asks where. `then` follows once it is saved.
void saveDocument(AppContext &context, std::function<void(AppContext &)> then = {});
void saveDocumentAs(AppContext &context, std::function<void(AppContext &)> then = {});
/// Takes the drawing of a file into this one.
void importDrawing(AppContext &context);
/// Takes the spacing of a project or of a mesh with nodal values.
void importSpacing(AppContext &context);
/// Writes the mesh in one of many formats.
void exportMesh(AppContext &context);
/// Remembers a file in the list of recent ones.
void rememberFile(AppContext &context, const std::filesystem::path &file);

} // namespace forefront
