#include "ui/dialogs/file_commands.hpp"

#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/files/files.hpp"
#include "core/files/source/source.hpp"
#include "ui/dialogs/changed_file.hpp"
#include "ui/dialogs/file_dialog.hpp"
#include "ui/dialogs/import_dialog.hpp"
#include "ui/dialogs/picture_spacing.hpp"
#include "ui/dialogs/question_dialog.hpp"
#include "ui/dialogs/read_in_background.hpp"
#include "ui/dialogs/tab_commands.hpp"
#include "ui/parts/shell.hpp"
#include "ui/platform/assets.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace forefront {
namespace {

constexpr const char *kProjectExtension = ".forefront";

FileFilter projects() {
    std::vector<std::string> extensions =
        allFormats().allExtensions([](const FileFormat &format) { return format.kind == FileKind::Project; });
    // The first one is given to new files.
    std::stable_partition(extensions.begin(), extensions.end(),
                          [](const std::string &each) { return each == kProjectExtension; });
    return {std::string("Projects (") + kProjectExtension + ")", std::move(extensions), "projects"};
}

Status save(Shell &context, const std::filesystem::path &file) {
    if (Status fault = notRegular(file); !fault.empty()) {
        return fault; // writing to a pipe could wait for ever
    }
    const std::string text = projectFileText(file, *context.document.current());
    if (Status status = writeFileAtomically(file, text); !status.empty()) {
        return status;
    }
    context.document.markSaved(file, stampOfContent(text));
    rememberFile(context, file);
    context.log.announce("Saved " + file.string());
    return {};
}

bool isProject(const FileFormat *format) {
    return format != nullptr && format->kind == FileKind::Project;
}

/// The state of a document whose changes the user has agreed to lose; none: nobody was asked.
using AgreedRevision = std::optional<std::uint64_t>;

/// Runs `then` after asking whether to save unsaved changes, unless the user has been asked about these.
void afterUnsavedBut(const AgreedRevision &agreed, Shell &context, std::function<void(Shell &)> then) {
    if (agreed == context.document.revision()) {
        context.dialogs.dismissPreviews(context);
        then(context);
    } else {
        afterUnsaved(context, std::move(then));
    }
}

/// Opens a project after asking about unsaved changes, or shows another tab where it is open. Returns the faults of a
/// file that cannot be read.
Diagnostics openProject(Shell &context, const std::filesystem::path &file, const AgreedRevision &agreed = {}) {
    if (showOtherTabOf(context, file)) {
        return {};
    }
    const auto notes = std::make_shared<ImportNotes>();
    const auto read = std::make_shared<Result<StampedDocument>>(readStamped(file, notes.get()));
    if (!*read) {
        return read->faults();
    }
    context.dialogs.dismissPreviews(context); // whether there are unsaved changes depends on it
    afterUnsavedBut(agreed, context, [file, read, notes, asked = context.document.dirty()](Shell &c) {
        if (asked && !c.document.dirty()) {
            *read = readStamped(file, nullptr); // read again: it may just have been saved
        }
        if (!*read) {
            c.log.add(read->faults());
            return;
        }
        showOpened(c, **read, *notes, file);
    });
    return {};
}

/// Opens a mesh, drawing or map as a new drawing once another thread has read it; then asks about unsaved changes.
void openForeign(Shell &context, const std::filesystem::path &file, const std::shared_ptr<FileOutcome> &outcome,
                 const AgreedRevision &agreed = {}) {
    const std::uint64_t loads = context.document.loads();
    readForeign(context, file, outcome, [file, loads, agreed](Shell &c, const auto &opened, const auto &notes) {
        if (!replacedWhileReading(c, file, loads)) {
            afterUnsavedBut(agreed, c,
                            [file, opened, notes](Shell &shell) { showOpened(shell, *opened, *notes, file); });
        }
    });
}

/// Makes the spacing of a project, mesh or grid that of the drawing once another thread has read it.
std::shared_ptr<const FileOutcome> importSpacingOf(Shell &context, const std::filesystem::path &file) {
    auto outcome = std::make_shared<FileOutcome>();
    const std::uint64_t loads = context.document.loads();
    readInBackground(context, file, outcome,
                     [&context, file, outcome, loads](const Progress &progress) -> Result<BackgroundTask::Finish> {
                         const auto notes = std::make_shared<ImportNotes>();
                         ImportOptions options;
                         options.progress = progress;
                         const auto read = std::make_shared<Result<SpacingSpec>>(
                             allFormats().readSpacing(file, options, notes.get()));
                         if (!*read) {
                             return read->faults();
                         }
                         return BackgroundTask::Finish([&context, file, outcome, notes, read, loads] {
                             if (replacedWhileReading(context, file, loads)) {
                                 return;
                             }
                             Result<Document> next = setImportedSpacing(*context.document.current(), **read);
                             if (!next) {
                                 outcome->faults = next.faults();
                                 return;
                             }
                             context.document.apply(*std::move(next), "Import spacing");
                             context.log.announce("Imported spacing from " + file.filename().string());
                             context.log.add(notes->diagnostics());
                         });
                     });
    return outcome;
}

std::string viewKey(const Shell &context) {
    std::error_code ignored;
    return std::filesystem::absolute(context.document.path(), ignored).lexically_normal().string();
}

/// Shows the part of the plane that was in view when the file was last closed; otherwise all of it.
void showLastView(Shell &context) {
    const auto known =
        context.document.path().empty() ? context.settings.views.end() : context.settings.views.find(viewKey(context));
    context.view.fitPending = known == context.settings.views.end();
    if (!context.view.fitPending) {
        context.view.fitted.reset();
        context.view.camera.centre = known->second.centre;
        context.view.camera.zoom = known->second.zoom;
    }
}

/// Returns the folder of the document, or else of the most recent file that passes `accepts`; empty: the working
/// folder.
template <class Accepts>
std::filesystem::path folderFor(const Shell &context, const Accepts &accepts) {
    if (!context.document.path().empty()) {
        return context.document.path().parent_path();
    }
    const std::vector<std::string> &recent = context.settings.recentFiles;
    const auto last = std::find_if(recent.begin(), recent.end(), accepts);
    return last == recent.end() ? std::filesystem::path() : std::filesystem::path(*last).parent_path();
}

/// Returns the folder that Save as starts in. Drawings that were opened to be imported may lie where nobody keeps
/// projects, such as in a folder of downloads.
std::filesystem::path saveFolder(const Shell &context) {
    return folderFor(context, [](const std::filesystem::path &file) { return file.extension() == kProjectExtension; });
}

} // namespace

std::vector<FileFilter> drawingFilters() {
    return openFilters("All drawings", {projects()}, [](const FileFormat &format) { return format.readsDomain; });
}

bool opensInBackground(const std::filesystem::path &file) {
    const FileFormat *const format = allFormats().detect(file);
    return format != nullptr && !isProject(format);
}

void rememberView(Shell &context) {
    if (context.document.path().empty() || context.view.fitPending) {
        return;
    }
    if (context.view.fitted) {
        context.settings.views.erase(viewKey(context)); // the whole drawing, whatever the size of the window
    } else {
        context.settings.views[viewKey(context)] = {context.view.camera.centre, context.view.camera.zoom};
    }
}

std::filesystem::path startFolder(const Shell &context) {
    return folderFor(context, [](const std::filesystem::path &) { return true; });
}

Result<StampedDocument> readStamped(const std::filesystem::path &file, ImportNotes *notes) {
    const FileStamp stamp = stampOf(file); // before reading: later changes are then found
    ImportOptions options;
    options.regularFile = true;
    Result<Document> read = readDocument(file, options, notes);
    return read ? Result<StampedDocument>(StampedDocument{*std::move(read), stamp}) : read.faults();
}

void readForeign(Shell &context, const std::filesystem::path &file, const std::shared_ptr<FileOutcome> &outcome,
                 UseForeign use) {
    readInBackground(
        context, file, outcome,
        [&context, file, use = std::move(use)](const Progress &progress) -> Result<BackgroundTask::Finish> {
            const auto notes = std::make_shared<ImportNotes>();
            ImportOptions options;
            options.progress = progress;
            Result<Document> read = readDocument(file, options, notes.get());
            if (!read) {
                return read.faults();
            }
            const auto opened = std::make_shared<const StampedDocument>(StampedDocument{*std::move(read), {}});
            return BackgroundTask::Finish([&context, use, opened, notes] { use(context, opened, notes); });
        });
}

namespace {

/// Tells that a drawing of another format is open; a warning if it is not all that the file has.
void tellOpened(Shell &context, const std::string &what, std::size_t shapes, std::size_t notes) {
    std::string text = what + " opened as a new drawing with " + ui::count(shapes) +
                       (shapes == 1 ? " shape" : " shapes") + "; save it as a project to keep your changes";
    if (notes == 0) {
        context.log.announce(std::move(text));
        return;
    }
    text += ". " + ui::count(notes) + (notes == 1 ? " note" : " notes") + " on what was left out or changed";
    context.log.add(Diagnostic{.severity = Severity::Warning,
                               .code = "left-out",
                               .message = std::move(text),
                               .advice = "read them in View > Log"});
}

} // namespace

void showDocument(Shell &context, const StampedDocument &read, const std::filesystem::path &file, std::size_t notes) {
    const FileFormat *const format = allFormats().detect(file);
    const bool project = isProject(format);
    const std::vector<Sample> gallery = sampleDrawings();
    std::error_code ignored;
    const auto sample = std::find_if(gallery.begin(), gallery.end(), [&](const Sample &s) {
        return std::filesystem::equivalent(s.path, file, ignored);
    });
    // Saving must not overwrite a sample or an imported drawing.
    const bool own = project && sample == gallery.end();
    rememberView(context);
    context.document.load(read.document, own ? file : std::filesystem::path(), false,
                          sample != gallery.end() ? sample->title : file.stem().string(), read.stamp);
    context.run.clear();
    restoreColours(context);
    context.examiner.abandon();
    context.selection.clear();
    context.view.isolatedBin.reset();
    showLastView(context);
    context.animate();
    if (!project && format != nullptr) {
        tellOpened(context, file.filename().string() + " (" + format->name + ")", read.document.shapes.size(), notes);
    }
}

void showOpened(Shell &context, const StampedDocument &read, const ImportNotes &notes,
                const std::filesystem::path &file) {
    showDocument(context, read, file, notes.diagnostics().size());
    context.log.add(notes.diagnostics());
    rememberFile(context, file);
}

void putFirst(std::vector<std::string> &recent, const std::filesystem::path &file) {
    constexpr std::size_t kMaxRecent = 12;
    std::error_code ignored;
    const std::string name = std::filesystem::absolute(file, ignored).lexically_normal().string();
    std::erase(recent, name);
    recent.insert(recent.begin(), name);
    recent.resize(std::min(recent.size(), kMaxRecent));
}

void rememberFile(Shell &context, const std::filesystem::path &file) {
    std::error_code ignored;
    const std::string name = std::filesystem::absolute(file, ignored).lexically_normal().string();
    const std::vector<Sample> gallery = sampleDrawings(); // which have a menu of their own
    if (std::any_of(gallery.begin(), gallery.end(),
                    [&](const Sample &s) { return std::filesystem::equivalent(s.path, name, ignored); })) {
        return;
    }
    if (context.document.path() == file) { // a project, which the next start opens again
        context.settings.lastFile = name;
    }
    std::vector<std::string> &recent = context.settings.recentFiles;
    putFirst(recent, name);
    std::erase_if(context.settings.views, [&](const auto &view) {
        return std::find(recent.begin(), recent.end(), view.first) == recent.end();
    });
}

void afterUnsaved(Shell &context, std::function<void(Shell &)> then) {
    finishInput(context); // what is being drawn is asked about, too
    if (!context.document.dirty()) {
        then(context);
        return;
    }
    const std::string name = context.document.title();
    std::vector<QuestionDialog::Answer> answers{{"cancel", "Cancel", false, {}},
                                                {"discard", "Don't save", false, then},
                                                {"save", "Save", true, [then](Shell &c) { saveDocument(c, then); }}};
    context.dialogs.open(std::make_unique<QuestionDialog>(
        "unsaved", "Save changes?", "The changes to " + name + " have not been saved.", std::move(answers)));
}

void beginDocument(Shell &context) {
    rememberView(context);
    Document fresh;
    fresh.options.method = context.settings.newMethod;
    fresh.options.improve = context.settings.newImprove;
    fresh.spacing.size = context.settings.newSize;
    fresh.spacing.gradation = context.settings.newGradation;
    fresh.spacing.segmentsPerTurn = context.settings.newPerTurn;
    fresh.spacing.elementsAcross = context.settings.newAcross;
    context.document.load(std::move(fresh), {});
    context.selection.clear();
    context.run.clear();
    restoreColours(context);
    if (!context.log.entries().empty()) {
        context.newsDismissed = context.log.entries().back().number;
    }
    context.view.isolatedBin.reset();
    context.plates.start = false; // the empty canvas was asked for
    context.view.fit({{0.0, 0.0}, {10.0, 10.0}});
    context.animate();
}

void newDocument(Shell &context) {
    afterUnsaved(context, beginDocument);
}

bool findSamples(Shell &context) {
    if (!sampleDrawings().empty()) {
        return true;
    }
    context.log.add(Diagnostic{.severity = Severity::Warning,
                               .code = "no-assets",
                               .message = "samples not found",
                               .advice = "set FOREFRONT_ASSETS to the folder that holds samples/"});
    return false;
}

void openFirstSample(Shell &context) {
    if (!findSamples(context)) {
        return;
    }
    const std::filesystem::path first = sampleDrawings().front().path;
    ImportNotes notes;
    if (const Result<StampedDocument> read = readStamped(first, &notes)) {
        showOpened(context, *read, notes, first);
    } else {
        context.log.add(read.faults());
    }
}

namespace {

/// Opens the file dialog; unsaved changes have been saved, or the user has agreed to lose them.
void chooseDocument(Shell &context) {
    const std::uint64_t agreed = context.document.revision();
    FileRequest request;
    request.id = "open";
    request.title = "Open";
    request.action = "Open";
    request.filters = drawingFilters();
    request.folder = startFolder(context);
    request.reads = [agreed](Shell &c, const std::filesystem::path &file) {
        auto outcome = opensInBackground(file) ? std::make_shared<FileOutcome>() : nullptr;
        if (outcome) {
            openForeign(c, file, outcome, agreed);
        }
        return outcome;
    };
    request.chosen = [agreed](Shell &c, const std::filesystem::path &file, const FileFilter &) {
        return openProject(c, file, agreed);
    };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

} // namespace

void openDocument(Shell &context) {
    afterUnsaved(context, chooseDocument);
}

void openDocument(Shell &context, const std::filesystem::path &file) {
    if (opensInBackground(file)) {
        openForeign(context, file, nullptr);
    } else {
        context.log.add(openProject(context, file));
    }
}

void saveDocument(Shell &context, std::function<void(Shell &)> then) {
    if (context.document.path().empty()) {
        saveDocumentAs(context, std::move(then));
    } else if (const FileStamp now = stampOf(context.document.path(), context.document.stamp());
               changedOnDisk(context, now)) {
        askAboutChange(context, now, std::move(then));
    } else {
        overwriteDocument(context, then);
    }
}

void overwriteDocument(Shell &context, const std::function<void(Shell &)> &then) {
    if (const Status faults = save(context, context.document.path()); !faults.empty()) {
        context.log.add(faults);
    } else if (then) {
        then(context);
    }
}

void saveDocumentAs(Shell &context, std::function<void(Shell &)> then) {
    FileRequest request;
    request.id = "save";
    request.title = "Save as";
    request.action = "Save";
    request.saves = true;
    request.filters = {projects()};
    request.folder = saveFolder(context);
    request.fixedFolder = !context.document.path().empty();
    const std::filesystem::path &path = context.document.path();
    request.name = path.empty() ? context.document.title() + kProjectExtension : path.filename().string();
    request.chosen = [then = std::move(then)](Shell &c, const std::filesystem::path &file, const FileFilter &) {
        Status faults = save(c, file);
        if (faults.empty() && then) {
            then(c);
        }
        return faults;
    };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

void importDrawing(Shell &context) {
    FileRequest request;
    request.id = "import";
    request.title = "Import drawing";
    request.action = "Import";
    request.filters = drawingFilters();
    request.folder = startFolder(context);
    request.reads = [](Shell &c, const std::filesystem::path &file) {
        auto outcome = std::make_shared<FileOutcome>();
        readInBackground(c, file, outcome, [&c, file](const Progress &progress) -> Result<BackgroundTask::Finish> {
            Result<std::unique_ptr<ImportDialog>> read = ImportDialog::open(file, progress);
            if (!read) {
                return read.faults();
            }
            const auto dialog = std::make_shared<std::unique_ptr<ImportDialog>>(*std::move(read));
            return BackgroundTask::Finish([&c, dialog] { c.dialogs.open(std::move(*dialog)); });
        });
        return outcome;
    };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

void importSpacing(Shell &context) {
    FileRequest request;
    request.id = "importspacing";
    request.title = "Import spacing";
    request.action = "Import";
    request.filters = {
        {"Projects, meshes, grids and pictures",
         allFormats().allExtensions([](const FileFormat &format) { return format.readsSpacing || format.readsMesh; }),
         "spacing"},
        {"All files", {}, "any"}};
    request.folder = startFolder(context);
    request.reads = [](Shell &c, const std::filesystem::path &file) {
        const FileFormat *const format = allFormats().detect(file);
        const bool picture = format != nullptr && format->kind == FileKind::Picture;
        return picture ? importPictureSpacing(c, file) : importSpacingOf(c, file);
    };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

} // namespace forefront
