#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/file_dialog.hpp"
#include "ui/parts/shell.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace forefront {

namespace {

/// Returns where a new picture goes: into the middle of the view if there is a drawing to fit it to; otherwise one unit
/// is a pixel, and the origin the lower left corner.
BackgroundPicture placed(const Shell &context, const Picture &picture) {
    BackgroundPicture result;
    result.file = picture.file.string();
    result.size = {static_cast<double>(picture.size.width), static_cast<double>(picture.size.height)};
    if (context.document.current()->shapes.empty()) {
        return result;
    }
    constexpr double kShare = 0.8; // of the view
    const Camera &camera = context.view.camera;
    const PixelRect &room = context.view.room;
    const double scale =
        kShare * std::min(camera.length(room.width) / result.size.x, camera.length(room.height) / result.size.y);
    result.size = scale * result.size;
    result.corner = camera.toPlane(room.centre()) - 0.5 * result.size;
    return result;
}

void show(Shell &context, const std::shared_ptr<const Picture> &picture) {
    Document next = *context.document.current();
    const bool same = next.picture && next.picture->file == picture->file;
    if (!same) { // else only its pixels are new
        next.picture = placed(context, *picture);
    }
    const bool alone = next.shapes.empty() && !same;
    context.pictures.accept(picture);
    context.document.apply(std::move(next), "Add background picture");
    showLayer(context.layers, "picture", true);
    context.tools.choose("picture", context);
    if (alone) {
        context.actions.run("view.fit", context);
    }
    context.log.announce(picture->file.filename().string() + " is below the drawing; " +
                         (same ? "its pixels were read again" : "choose Calibrate to set its scale"));
    context.animate();
}

} // namespace

void addPicture(Shell &context, const std::filesystem::path &file) {
    std::error_code ignored;
    const std::filesystem::path path = std::filesystem::absolute(file, ignored).lexically_normal();
    if (context.task.busy()) {
        context.log.announce("Cancelled " + context.task.name());
    }
    context.task.start("reading " + path.filename().string(),
                       [&context, path](const Progress &) -> BackgroundTask::Finish {
                           auto read = std::make_shared<Result<std::shared_ptr<const Picture>>>(readPicture(path));
                           return [&context, read] {
                               if (*read) {
                                   show(context, **read);
                               } else {
                                   context.log.add(read->faults());
                               }
                           };
                       });
    context.animate();
}

void addPicture(Shell &context) {
    FileRequest request;
    request.id = "picture";
    request.title = "Add background picture";
    request.action = "Add";
    request.filters = {{"Pictures (PNG, JPEG)", {".png", ".jpg", ".jpeg"}, "picture"}, {"All files", {}, "any"}};
    request.folder = startFolder(context);
    request.chosen = [](Shell &c, const std::filesystem::path &file, const FileFilter &) -> Diagnostics {
        const Result<PixelSize> size = readPictureSize(file);
        if (!size) {
            return size.faults();
        }
        addPicture(c, file);
        return {};
    };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

void openDropped(Shell &context, const std::filesystem::path &file) {
    isPictureName(file) ? addPicture(context, file) : openDocument(context, file);
}

void followPicture(Shell &context) {
    context.pictures.follow(*context.document.current(), context.document.loads());
    Diagnostics faults;
    if (context.pictures.refresh(faults)) {
        context.animate();
    }
    for (Diagnostic &fault : faults) {
        fault.severity = Severity::Warning; // the drawing itself is complete
        context.log.add(std::move(fault));
    }
}

} // namespace forefront
