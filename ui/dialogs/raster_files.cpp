#include "core/engine/spacing/parts/expression/spacing_functions.hpp"
#include "core/files/elevations.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/file_dialog.hpp"
#include "ui/dialogs/read_in_background.hpp"
#include "ui/parts/shell.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

namespace forefront {

namespace {

/// Returns the name of a file without its extension as the name of a raster, or "raster" if it cannot be one; with a
/// number if it is taken.
std::string nameForRaster(const std::filesystem::path &file, const RasterMap &taken) {
    std::string stem = file.stem().string();
    if (!checkRasterName(stem).empty()) {
        stem = "raster";
    }
    std::string name = stem;
    for (int number = 2; taken.contains(name); ++number) {
        name = stem + std::to_string(number);
    }
    return name;
}

void useRaster(Shell &context, const std::filesystem::path &file, const std::shared_ptr<const Raster> &raster,
               const ImportNotes &notes) {
    Document next = *context.document.current();
    const std::string name = nameForRaster(file, next.spacing.rasters);
    next.spacing.rasters[name] = raster;
    context.document.apply(std::move(next), "Add raster");
    context.log.announce("Added the raster " + file.filename().string() + ": expressions of the spacing call it as " +
                         name + "(x,y)");
    context.log.add(notes.diagnostics());
}

/// Adds a raster to the drawing once another thread has read it.
std::shared_ptr<const FileOutcome> readRasterOf(Shell &context, const std::filesystem::path &file) {
    auto outcome = std::make_shared<FileOutcome>();
    const std::uint64_t loads = context.document.loads();
    readInBackground(context, file, outcome,
                     [&context, file, loads](const Progress &progress) -> Result<BackgroundTask::Finish> {
                         const auto notes = std::make_shared<ImportNotes>();
                         ImportOptions options;
                         options.progress = progress;
                         Result<Raster> read = readRaster(file, options, notes.get());
                         if (!read) {
                             return read.faults();
                         }
                         const auto raster = std::make_shared<const Raster>(*std::move(read));
                         return BackgroundTask::Finish([&context, file, notes, raster, loads] {
                             if (!replacedWhileReading(context, file, loads)) {
                                 useRaster(context, file, raster, *notes);
                             }
                         });
                     });
    return outcome;
}

} // namespace

void addRaster(Shell &context) {
    FileRequest request;
    request.id = "addraster";
    request.title = "Add raster";
    request.action = "Add";
    request.filters = {{"Rasters (.asc, .tif)", {".asc", ".tif", ".tiff"}, "raster"}, {"All files", {}, "any"}};
    request.folder = startFolder(context);
    request.reads = readRasterOf;
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

} // namespace forefront
