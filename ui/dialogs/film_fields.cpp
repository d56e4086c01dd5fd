#include "ui/dialogs/film_fields.hpp"

#include "ui/parts/shell.hpp"

#include <imgui.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <utility>

namespace forefront::film_fields {

void number(Workspace &context, const std::string &field, double &value, double minimum, double maximum) {
    double entered = value;
    if (ui::inputNumber(context, field, entered, 70.0F) && ui::checkRange(context, field, entered, minimum, maximum)) {
        value = entered;
    }
}

FileRequest exportRequest(const Shell &context, std::string id, std::string title, const std::string &ending) {
    const std::filesystem::path &document = context.document.path();
    FileRequest request;
    request.id = std::move(id);
    request.title = std::move(title);
    request.action = "Export";
    request.saves = true;
    request.folder = document.parent_path();
    request.name = (document.empty() ? context.document.title() : document.stem().string()) + ending;
    return request;
}

Box2 canvasBox(const View &view) {
    const PixelRect &room = view.room;
    return boxOf(view.camera.toPlane({room.x, room.y}),
                 view.camera.toPlane({room.x + room.width, room.y + room.height}));
}

void layers(Workspace &context, const std::string &prefix, FilmLayers &layers) {
    constexpr std::array<const char *, wordsOf<FilmLayer>().size()> kLabels{
        "Mesh", "Boundary", "Front", "Candidates", "Grid", "Caption", "Labels", "Improvement", "Colours"};
    constexpr auto kSecondRow = static_cast<std::size_t>(FilmLayer::Improvement); // there is no room in the first
    ui::rowLabel(context, "Show", kFields);
    for (std::size_t k = 0; k < kLabels.size(); ++k) {
        if (k == kSecondRow) {
            ui::rowLabel(context, "", kFields);
        } else if (k > 0) {
            ImGui::SameLine(0, context.px(14));
        }
        ui::checkbox(context, prefix + "layer/" + std::string(wordsOf<FilmLayer>()[k]), kLabels[k], layers.shown[k]);
    }
}

} // namespace forefront::film_fields
