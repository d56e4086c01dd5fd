#include "ui/dialogs/import_dialog.hpp"

#include "core/edit/insert_document.hpp"
#include "core/edit/shape_geometry.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <cmath>

namespace forefront {

void ImportDialog::insert(Shell &context) const {
    Selection added;
    context.document.apply(insertDrawing(*context.document.current(), drawing_, scale_, &added), "Import drawing");
    context.selection = std::move(added);
    context.actions.run("view.fit", context);
    const std::size_t count = drawing_.shapes.size();
    context.log.tell(ui::count(count) + (count == 1 ? " shape" : " shapes") + " imported from " +
                     file_.filename().string());
    context.log.add(notes_.diagnostics());
}

bool ImportDialog::draw(Shell &context) {
    std::size_t nodes = 0;
    for (const auto &shape : drawing_.shapes) {
        nodes += shape->nodes.size();
    }
    const Box2 box = boundsOf(drawing_), here = boundsOf(*context.document.current());
    const auto extent = [](const Box2 &b, double scale) {
        return b.empty() ? std::string("nothing")
                         : ui::number(scale * b.size().x) + " \xc3\x97 " + ui::number(scale * b.size().y);
    };
    ui::field(context, "Shapes", ui::count(drawing_.shapes.size()), 130.0F);
    ui::field(context, "Nodes", ui::count(nodes), 130.0F);
    ui::field(context, "Size in file", extent(box, 1.0), 130.0F);
    ui::field(context, "Current drawing", extent(here, 1.0), 130.0F);
    ImGui::Dummy({0, context.px(6)});
    ImGui::AlignTextToFramePadding();
    ui::muted(context, "1 unit in the file =");
    ImGui::SameLine();
    double scale = scale_;
    if (ui::inputNumber(context, "dialog/importoptions/scale", scale, 100.0F) && scale > 0.0) {
        scale_ = scale;
    }
    ImGui::SameLine();
    ui::muted(context, "drawing units");
    // Common units of drawings.
    const struct {
        const char *id, *label;
        double factor;
    } common[] = {{"same", "same", 1.0},
                  {"mm", "mm to m", 0.001},
                  {"inch", "inch to mm", 25.4},
                  {"point", "px to mm", 25.4 / 96.0}};
    for (const auto &choice : common) {
        if (ui::button(context, std::string("dialog/importoptions/") + choice.id, choice.label,
                       scale_ == choice.factor ? ui::ButtonKind::Primary : ui::ButtonKind::Plain)) {
            scale_ = choice.factor;
        }
        ImGui::SameLine();
    }
    ImGui::NewLine();
    ui::field(context, "Size after import", extent(box, scale_), 130.0F);
    for (const ImportNote &note : notes_.entries()) {
        ui::small(context, note.message + (note.count > 1 ? " (" + ui::count(note.count) + " times)" : ""), true);
    }
    ImGui::Dummy({0, context.px(8)});
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - context.px(258));
    if (ui::button(context, "dialog/importoptions/cancel", "Cancel", ui::ButtonKind::Plain, true, 124.0F)) {
        return false;
    }
    ImGui::SameLine(0, context.px(10));
    if (ui::button(context, "dialog/importoptions/ok", "Import", ui::ButtonKind::Primary, !drawing_.shapes.empty(),
                   124.0F)) {
        insert(context);
        return false;
    }
    return true;
}

} // namespace forefront
