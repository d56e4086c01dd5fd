#include "core/engine/spacing/parts/expression/spacing_functions.hpp"
#include "core/files/elevations.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/file_dialog.hpp"
#include "ui/parts/shell.hpp"

#include <memory>
#include <string>
#include <utility>

namespace forefront {

namespace {

/// Returns the name of a raster by that of its file, "raster" if that cannot be one, with a number if it is taken.
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

Diagnostics useRaster(Shell &context, const std::filesystem::path &file) {
    ImportNotes notes;
    Result<Raster> raster = readRaster(file, {}, &notes);
    if (!raster) {
        return raster.faults();
    }
    Document next = *context.document.current();
    const std::string name = nameForRaster(file, next.spacing.rasters);
    next.spacing.rasters[name] = std::make_shared<const Raster>(std::move(*raster));
    context.document.apply(std::move(next), "Add raster");
    context.log.announce("Added the raster " + file.filename().string() + ": expressions of the spacing call it as " +
                         name + "(x,y)");
    context.log.add(notes.diagnostics());
    return {};
}

} // namespace

void addRaster(Shell &context) {
    FileRequest request;
    request.id = "addraster";
    request.title = "Add raster";
    request.action = "Add";
    request.filters = {{"Rasters (.asc)", {".asc"}, "raster"}, {"All files", {}, "any"}};
    request.folder = startFolder(context);
    request.chosen = [](Shell &c, const std::filesystem::path &file, const FileFilter &) { return useRaster(c, file); };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

} // namespace forefront
