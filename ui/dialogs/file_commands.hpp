#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"
#include "core/files/source/file_stamp.hpp"
#include "ui/dialogs/file_list.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

class ActionRegistry;
class ImportNotes;
struct FileOutcome;
struct Shell;

/// A document with the stamp of its file from before it was read; unknown if it is not saved back to that file.
struct StampedDocument {
    Document document;
    FileStamp stamp;
};
/// Reads a document from a regular file.
Result<StampedDocument> readStamped(const std::filesystem::path &file, ImportNotes *notes);

/// What is done with a drawing that was read, and the notes of its reader, on the thread of the window.
using UseForeign = std::function<void(Shell &, const std::shared_ptr<const StampedDocument> &,
                                      const std::shared_ptr<const ImportNotes> &)>;
/// Reads a mesh, drawing or map on another thread, in place of what is being read there. Faults go to `outcome`; if
/// that is null, they are logged.
void readForeign(Shell &context, const std::filesystem::path &file, const std::shared_ptr<FileOutcome> &outcome,
                 UseForeign use);

/// Returns the filters of dialogs that open drawings.
std::vector<FileFilter> drawingFilters();
/// Returns true for files that may be large: all but projects, and those whose format is unknown.
bool opensInBackground(const std::filesystem::path &file);

// The commands of the File menu. They report faults in the log.

/// Runs `then` after asking whether to save unsaved changes.
void afterUnsaved(Shell &context, std::function<void(Shell &)> then);
void newDocument(Shell &context);
/// Opens an empty document with the settings for new ones, without asking about unsaved changes.
void beginDocument(Shell &context);
/// Logs a warning if there are no samples, since the assets were not found. Returns true if there are some.
bool findSamples(Shell &context);
/// Opens the first sample, without asking about unsaved changes; logs that there is none.
void openFirstSample(Shell &context);
/// Opens the file dialog, after asking about unsaved changes.
void openDocument(Shell &context);
/// Opens a file after asking about unsaved changes. Other files than projects may be large: they are read first, as the
/// background task of the shell, which Esc cancels.
void openDocument(Shell &context, const std::filesystem::path &file);
/// Saves the document to its file, or asks for one. If another program has changed the file, asks what to do. Runs
/// `then` once it is saved.
void saveDocument(Shell &context, std::function<void(Shell &)> then = {});
void saveDocumentAs(Shell &context, std::function<void(Shell &)> then = {});
/// Saves the document to its file, even if another program has changed it. Runs `then`, if not empty, once it is saved.
void overwriteDocument(Shell &context, const std::function<void(Shell &)> &then);
/// Adds the drawing of a file to the current one.
void importDrawing(Shell &context);
/// Imports the spacing of a project, of a mesh with nodal values, of a grid of sizes or of a picture.
void importSpacing(Shell &context);
/// Asks for a raster that the expression of the spacing can call, and adds it under the name of its file.
void addRaster(Shell &context);
/// Asks for a picture to put below the drawing.
void addPicture(Shell &context);
/// Puts a picture below the drawing once another thread has read it.
void addPicture(Shell &context, const std::filesystem::path &file);
/// Keeps the pixels of the picture in step with the document; logs why they cannot be read. Called once per frame.
void followPicture(Shell &context);
/// Adds a file that was dropped onto the window if it is a picture; otherwise opens it.
void openDropped(Shell &context, const std::filesystem::path &file);
/// Exports the mesh in a format that the user chooses; `proposed`: the id of the one chosen at first.
void exportMesh(Shell &context, std::string_view proposed = {});
/// Returns what exporting would write now: "Export 2 943 triangles".
std::string exportLabel(const Shell &context);
/// Asks for a file of rules, and makes them those of the document, with the classic method.
void openRules(Shell &context);
/// Asks for a file, and writes the rules of the document that differ from their defaults.
void saveRules(Shell &context);
/// Writes the run of the document as a film: an animation, numbered frames or one moment.
void exportFilm(Shell &context);
/// Writes the moment of the run that the canvas shows as a picture; the run stays where it is.
void exportMoment(Shell &context);
/// Returns the folder that a file dialog starts in: the folder of the document or of the last file.
std::filesystem::path startFolder(const Shell &context);
/// Makes a document read from `file` the open one, without asking. Only projects are saved back to their file.
void showDocument(Shell &context, const StampedDocument &read, const std::filesystem::path &file,
                  std::size_t notes = 0);
/// Does the same for a document that a user opened: logs the notes of its reader, and remembers the file.
void showOpened(Shell &context, const StampedDocument &read, const ImportNotes &notes,
                const std::filesystem::path &file);
/// Registers the actions of files and editing.
void addEditActions(ActionRegistry &actions);
/// Remembers which part of the plane is in view, for when the open file is opened again.
void rememberView(Shell &context);
/// Puts a file at the front of a list of recent ones, and drops the last of too many.
void putFirst(std::vector<std::string> &recent, const std::filesystem::path &file);
/// Adds a file to the recent files.
void rememberFile(Shell &context, const std::filesystem::path &file);

} // namespace forefront
