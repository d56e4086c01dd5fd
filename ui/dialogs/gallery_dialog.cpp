#include "ui/dialogs/gallery_dialog.hpp"

#include "ui/dialogs/file_commands.hpp"
#include "ui/parts/shell.hpp"

#include <imgui.h>

#include <optional>

namespace forefront {

GalleryDialog::GalleryDialog(Shell &context) : cards_(context.background, sampleCards()) {}

bool GalleryDialog::draw(Shell &context) {
    ImGui::BeginChild("cards", {0, 0}, false, ImGuiWindowFlags_NoNav);
    const std::optional<std::size_t> chosen = cards_.draw(context, "dialog/gallery/");
    ImGui::EndChild();
    if (chosen) {
        openDocument(context, cards_.all()[*chosen].path);
    }
    return !chosen;
}

} // namespace forefront
