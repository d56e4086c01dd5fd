#include "core/files/text/atomic_file.hpp"
#include "core/teaching/film/film_files.hpp"
#include "ui/dialogs/export_dialog.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/file_dialog.hpp"
#include "ui/dialogs/film_fields.hpp"
#include "ui/parts/shell.hpp"

#include <imgui.h>

#include <array>
#include <memory>
#include <string>
#include <utility>

namespace forefront {

namespace {

constexpr const char *kMomentName = "dialog/moment/";

/// The settings that the dialog edits.
struct MomentSettings {
    FilmLayers layers;
    int width = 800;
    bool asOnCanvas = true; ///< the part of the plane that the canvas shows; else the whole domain
};

/// Returns the layers of a picture that the canvas shows now; candidates with their labels.
FilmLayers layersOnCanvas(Shell &context) {
    const auto shown = [&](const char *layer) {
        const LayerSlot *const slot = context.layer(layer);
        return slot != nullptr && slot->visible;
    };
    FilmLayers layers;
    const std::array<std::pair<FilmLayer, const char *>, 8> kSame{{{FilmLayer::Mesh, "mesh"},
                                                                   {FilmLayer::Boundary, "boundary"},
                                                                   {FilmLayer::Front, "front"},
                                                                   {FilmLayer::Candidates, "candidates"},
                                                                   {FilmLayer::Labels, "candidates"},
                                                                   {FilmLayer::Grid, "grid"},
                                                                   {FilmLayer::Improvement, "improvement"},
                                                                   {FilmLayer::Colours, "colours"}}};
    for (const auto &[layer, name] : kSame) {
        layers.shown[static_cast<std::size_t>(layer)] = shown(name);
    }
    return layers;
}

Diagnostics writeMoment(Shell &context, const MomentSettings &settings, const std::filesystem::path &file) {
    const std::shared_ptr<const SessionSnapshot> moment = context.run.snapshot();
    FilmSheet sheet;
    sheet.box = sheetBox(settings.asOnCanvas ? film_fields::canvasBox(context.view) : moment->mesh->mesh.bounds());
    sheet.width = settings.width;
    sheet.cut = settings.asOnCanvas;
    sheet.legend = settings.layers.has(FilmLayer::Labels);
    const auto write = [moment, sheet, layers = settings.layers, file](const Progress &) {
        return writeFileAtomically(file, pictureOf(file, sceneOf(*moment, sheet, layers)));
    };
    const std::string what = moment->improvement ? "step " + std::to_string(moment->improveStep) + " of the improvement"
                                                 : "advance " + std::to_string(moment->advance);
    const auto done = [file, what](Shell &c) { c.log.announce("Exported " + what + " to " + file.string()); };
    context.dialogs.open(std::make_unique<WriteDialog>(context.background, file.string(), write, done));
    return {};
}

void drawFields(Shell &context, MomentSettings &settings) {
    ui::rowLabel(context, "Width", film_fields::kFields);
    film_fields::whole(context, std::string(kMomentName) + "width", settings.width, FilmPlan::kMinWidth,
                       FilmPlan::kMaxWidth);
    ImGui::SameLine();
    ui::muted(context, "pixels");
    ImGui::SameLine(0, context.px(24));
    ui::checkbox(context, std::string(kMomentName) + "view", "As on the canvas", settings.asOnCanvas);
    ui::tooltip(context, "Show the part of the plane that the canvas shows; else the whole domain");
    film_fields::layers(context, kMomentName, settings.layers);
}

} // namespace

void exportMoment(Shell &context) {
    if (!context.run.hasRun() || context.run.showsFile()) {
        context.log.refuse("There is no run to show; mesh the drawing first");
        return;
    }
    FileRequest request = film_fields::exportRequest(context, "moment", "Export picture of the moment",
                                                     "-" + std::to_string(context.run.now().position()) + ".svg");
    request.filters = {
        {"SVG drawing (.svg)", {".svg"}, "svg", "A vector drawing; its labels stay text."},
        {"PDF page (.pdf)", {".pdf"}, "pdf", "A vector drawing on a page of its size; labels stay text."},
        {"PNG picture (.png)", {".png"}, "png", "Pixels."}};
    request.needs = {.mesh = true, .front = true, .cells = true, .explanation = true};
    const auto settings = std::make_shared<MomentSettings>();
    settings->layers = layersOnCanvas(context);
    request.chosen = [settings](Shell &c, const std::filesystem::path &file, const FileFilter &) {
        return writeMoment(c, *settings, file);
    };
    request.extraLines = [](const FileFilter &) { return 3; };
    request.extra = [settings](Shell &c, const FileFilter &) {
        drawFields(c, *settings);
        return true;
    };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

} // namespace forefront
