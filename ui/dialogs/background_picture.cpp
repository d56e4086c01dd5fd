#include "core/drawing_files/world_file/world_file.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/file_dialog.hpp"
#include "ui/dialogs/read_in_background.hpp"
#include "ui/parts/shell.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace forefront {

namespace {

/// Returns true if the width and height of the pixels agree with those of the old picture to a percent.
bool sameProportions(const BackgroundPicture &old, PixelSize size) {
    const double ratio = (old.size.x / old.size.y) / (static_cast<double>(size.width) / size.height);
    return std::fabs(ratio - 1.0) < 0.01;
}

/// Returns where a new picture goes: in the place of the old one, whose calibration and lock it keeps; else into the
/// middle of the view if there is a drawing to fit it to; otherwise one unit is a pixel, and the origin the lower left
/// corner.
BackgroundPicture placed(const Shell &context, const Picture &picture) {
    if (const std::optional<BackgroundPicture> &old = context.document.current()->picture) {
        BackgroundPicture result = *old;
        result.file = picture.file.string();
        result.size.y = result.size.x * picture.size.height / picture.size.width;
        return result;
    }
    BackgroundPicture result;
    result.file = picture.file.string();
    result.size = {static_cast<double>(picture.size.width), static_cast<double>(picture.size.height)};
    if (context.document.current()->shapes.empty()) {
        return result;
    }
    constexpr double kShare = 0.8; // part of the view that the picture fills
    const Camera &camera = context.view.camera;
    const PixelRect &room = context.view.room;
    const double scale =
        kShare * std::min(camera.length(room.width) / result.size.x, camera.length(room.height) / result.size.y);
    result.size = scale * result.size;
    result.corner = camera.toPlane(room.centre()) - 0.5 * result.size;
    return result;
}

/// Reads the world file beside a picture; nothing if there is none.
std::optional<Result<PicturePlace>> readWorldFile(const std::filesystem::path &picture, PixelSize size) {
    for (const std::filesystem::path &name : worldFileNames(picture)) {
        std::error_code missing;
        if (!std::filesystem::is_regular_file(name, missing)) {
            continue;
        }
        std::ifstream file(name, std::ios::binary);
        std::array<char, 4096> text{}; // far more than six numbers
        file.read(text.data(), static_cast<std::streamsize>(text.size()));
        const std::string_view read(text.data(), static_cast<std::size_t>(file.gcount()));
        return parseWorldFile(read, size.width, size.height, name);
    }
    return std::nullopt;
}

/// Moves a picture to the place that its world file gives.
void placeByWorldFile(BackgroundPicture &picture, const PicturePlace &place) {
    picture.corner = place.corner;
    picture.size = place.size;
    picture.angle = place.angle;
}

/// Returns the log entry for a picture that was added or replaces `old`.
std::string noteFor(const Picture &picture, const std::optional<BackgroundPicture> &old) {
    const std::string name = picture.file.filename().string();
    if (!old) {
        return name + " is below the drawing; choose Calibrate to set its scale";
    }
    if (old->file == picture.file) {
        return name + " is below the drawing; its pixels were read again";
    }
    return name + " replaces the previous picture and keeps its scale" +
           (sameProportions(*old, picture.size) ? "" : "; its proportions differ, so check the calibration");
}

void show(Shell &context, const std::shared_ptr<const Picture> &picture,
          const std::optional<Result<PicturePlace>> &world) {
    Document next = *context.document.current();
    const std::optional<BackgroundPicture> old = next.picture;
    if (!old || old->file != picture->file) { // else only its pixels are new
        next.picture = placed(context, *picture);
        if (!old && world && *world) { // a replaced picture keeps its place
            placeByWorldFile(*next.picture, **world);
        }
    }
    const bool placedByFile = !old && world && *world;
    const bool alone = next.shapes.empty() && !old;
    context.pictures.accept(picture);
    context.document.apply(std::move(next), old ? "Replace background picture" : "Add background picture");
    std::string note = placedByFile ? picture->file.filename().string() + " is below the drawing, where its world file "
                                                                          "places it"
                                    : noteFor(*picture, old);
    if (world && !*world) {
        for (Diagnostic fault : world->faults()) {
            fault.severity = Severity::Warning; // the picture is there, but elsewhere
            context.log.add(std::move(fault));
        }
    }
    if (!old && std::exchange(context.snapping.toGrid, false)) {
        context.snapping.offForPicture = true;
        note += ". Snapping to the grid is off for tracing";
    }
    showLayer(context.layers, "picture", true);
    context.tools.choose("picture", context);
    if (alone || placedByFile) {
        context.actions.run("view.fit", context);
    }
    context.log.announce(note);
    context.animate();
}

} // namespace

void addPicture(Shell &context, const std::filesystem::path &file) {
    std::error_code ignored;
    const std::filesystem::path path = std::filesystem::absolute(file, ignored).lexically_normal();
    readInBackground(context, path, nullptr, [&context, path](const Progress &) -> Result<BackgroundTask::Finish> {
        const Result<std::shared_ptr<const Picture>> read = readPicture(path);
        if (!read) {
            return read.faults();
        }
        return BackgroundTask::Finish(
            [&context, picture = *read, world = readWorldFile(path, (*read)->size)] { show(context, picture, world); });
    });
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
    if (context.snapping.offForPicture && !context.document.current()->picture) {
        context.snapping.toGrid = true; // there is nothing left to trace
        context.snapping.offForPicture = false;
    }
    context.pictures.follow(*context.document.current(), context.document.loads());
    Diagnostics news;
    if (context.pictures.refresh(news)) {
        context.animate();
    }
    for (Diagnostic &item : news) {
        if (item.severity == Severity::Note) {
            context.log.announce(item.message);
        } else {
            item.severity = Severity::Warning; // the drawing itself is complete
            context.log.add(std::move(item));
        }
    }
}

} // namespace forefront
