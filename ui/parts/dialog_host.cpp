#include "ui/parts/preview_dialog.hpp"
#include "ui/parts/shell.hpp"
#include "ui/style/imgui_versions.hpp"
#include "ui/widgets/shortened.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace forefront {

namespace {

/// Places the next window for a dialog whose rectangle was `last`; null: it opens. It is centred. A dialog that is
/// as high as its content keeps its upper edge, so that nothing moves under the pointer when a click changes the
/// content.
void placeDialog(const Dialog &dialog, const PixelRect *last, float margin) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float middle = std::round(size.x / 2);
    if (last == nullptr || dialog.height() > 0.0F) {
        ImGui::SetNextWindowPos({middle, std::round(size.y / 2)}, ImGuiCond_Always, {0.5F, 0.5F});
        return;
    }
    const float lowest = size.y - margin / 2 - static_cast<float>(last->height);
    ImGui::SetNextWindowPos({middle, std::min(static_cast<float>(last->y), lowest)}, ImGuiCond_Always, {0.5F, 0.0F});
}

/// Places the next window over the options bar. It grows if its content needs more than one row.
void placeInBar(const WidgetContext &context) {
    const WidgetRegistry::Widget *const bar = context.widgets.find("options");
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float y = bar != nullptr ? static_cast<float>(bar->rect.y) : 0.0F;
    const float height = bar != nullptr ? static_cast<float>(bar->rect.height) : 0.0F;
    ImGui::SetNextWindowPos({0.0F, y});
    ImGui::SetNextWindowSize({size.x, 0.0F});
    ImGui::SetNextWindowSizeConstraints({size.x, height}, {size.x, std::max(height, size.y - y)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(12), context.px(5)));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
}

/// Places the next window over the column, or where that would be: what is on the canvas stays in sight, however narrow
/// the window.
void placeOverColumn(const WidgetContext &context) {
    constexpr double kWidth = 304.0; // of a dialog without a column, design pixels
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const WidgetRegistry::Widget *const bar = context.widgets.find("options");
    const WidgetRegistry::Widget *const column = context.widgets.find("column");
    const WidgetRegistry::Widget *const status = context.widgets.find("status/pointer");
    const float top = bar != nullptr ? static_cast<float>(bar->rect.y + bar->rect.height) : 0.0F;
    const float bottom = status != nullptr ? static_cast<float>(status->rect.y) : size.y;
    const float covered = column != nullptr ? static_cast<float>(column->rect.width) : 0.0F;
    const float width = std::min(std::max(covered, context.px(kWidth)), size.x);
    ImGui::SetNextWindowPos({size.x - width, top});
    ImGui::SetNextWindowSize({width, std::max(1.0F, bottom - top)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(12), context.px(12)));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
}

/// Places the next window of a dialog over the middle of the window.
void placeInMiddle(const WidgetContext &context, const Dialog &dialog, const std::string &name) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float margin = context.px(24);
    const float width = std::min(context.px(static_cast<double>(dialog.width())), size.x - margin);
    const float height = std::min(context.px(static_cast<double>(dialog.height())), size.y - margin);
    const WidgetRegistry::Widget *const last = context.widgets.find(name);
    placeDialog(dialog, last == nullptr ? nullptr : &last->rect, margin);
    ImGui::SetNextWindowSize({width, dialog.height() > 0.0F ? height : 0.0F});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, size.y - margin});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(22), context.px(18)));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, context.px(10));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
}

/// Draws the title of a dialog and the button that closes it. Returns true if that was pressed.
bool drawTitleRow(WidgetContext &context, const Dialog &dialog, const std::string &name) {
    ImGui::PushFont(context.fonts.title);
    const std::string title = dialog.title();
    const float button = ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x - context.px(26);
    const std::string shown = ui::withoutMiddle(title, button - ImGui::GetCursorPosX() - context.px(8));
    ImGui::TextUnformatted(shown.c_str());
    ImGui::PopFont();
    ui::mark(context, name + "/title");
    if (shown != title) {
        ui::tooltip(context, title);
    }
    ImGui::SameLine(button);
    const bool closed =
        ui::iconButton(context, name + "/close", icon::kCross, "Close (Esc)", false, dialog.closesOnEscape(), 26.0F);
    ImGui::Dummy({0, context.px(4)});
    return closed;
}

} // namespace

bool offersDrawing(const Shell &context) {
    const auto *const dialog = dynamic_cast<const PreviewDialog *>(context.dialogs.top());
    return dialog != nullptr && !dialog->inOptionsBar();
}

void DialogHost::closeAll() {
    stack_.clear();
    opening_.clear();
    dismissed_.clear();
    appeared_ = true;
}

void DialogHost::dismissPreviews(Shell &context) {
    for (auto *list : {&stack_, &opening_}) {
        for (const std::unique_ptr<Dialog> &dialog : *list) {
            auto *const preview = dynamic_cast<PreviewDialog *>(dialog.get());
            if (preview != nullptr && std::find(dismissed_.begin(), dismissed_.end(), preview) == dismissed_.end()) {
                preview->dismiss(context);
                dismissed_.push_back(preview);
            }
        }
    }
}

void DialogHost::drawFrom(std::size_t level, Shell &context, std::vector<bool> &keep) {
    Dialog &dialog = *stack_[level];
    const std::string title = dialog.title() + "###dialog" + dialog.id();
    const std::string name = std::string("dialog/") + dialog.id();
    auto *const preview = dynamic_cast<PreviewDialog *>(&dialog);
    const bool inBar = preview != nullptr && preview->inOptionsBar();
    inBar ? placeInBar(context) : preview != nullptr ? placeOverColumn(context) : placeInMiddle(context, dialog, name);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, context.theme.popup);
    ImGui::PushStyleColor(ImGuiCol_PopupBg, context.theme.popup);
    if (!ImGui::IsPopupOpen(title.c_str())) {
        ImGui::OpenPopup(title.c_str());
    }
    if (ImGui::BeginPopupModal(title.c_str(), nullptr,
                               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav)) {
        const bool closed = !inBar && drawTitleRow(context, dialog, name);
        const bool isTop = level + 1 == keep.size();
        // Esc first restores the value of a field whose text was changed.
        const std::optional<FieldFocus::Entry> &typing = context.widgets.fields.entry;
        const bool restores = typing && typing->text != typing->initial;
        const bool escape = isTop && !restores && dialog.closesOnEscape() && imgui::keyPressed(key::kEscape, false) &&
                            !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId);
        ui::startTabbing(context);
        const bool dismissed = std::find(dismissed_.begin(), dismissed_.end(), &dialog) != dismissed_.end();
        keep[level] = !dismissed && dialog.draw(context) && !escape && !closed;
        if (preview != nullptr && !dismissed && (escape || closed)) {
            preview->dismiss(context);
        }
        appeared_ = appeared_ && !ImGui::IsWindowAppearing();
        if (!ImGui::IsWindowAppearing()) { // its size is known
            ui::markWindow(context, name);
        }
        // A dialog on top must begin inside this one, or Dear ImGui closes this one.
        if (!isTop) {
            drawFrom(level + 1, context, keep);
        }
        if (!keep[level]) {
            ImGui::CloseCurrentPopup();
        }
        ImGui::EndPopup();
    }
    ImGui::PopStyleColor(2);
    ImGui::PopStyleVar(3);
}

void DialogHost::draw(Shell &context) {
    for (std::unique_ptr<Dialog> &dialog : opening_) {
        stack_.push_back(std::move(dialog));
        context.fieldFault = {}; // an earlier dialog of the same kind may have left one
        context.animate();
    }
    opening_.clear();
    // Dialogs opened while another draws wait in opening_ until the next frame, so that the stack does not change here.
    const bool dims = std::any_of(stack_.begin(), stack_.end(), [](const std::unique_ptr<Dialog> &dialog) {
        return dynamic_cast<const PreviewDialog *>(dialog.get()) == nullptr;
    });
    ImGui::GetStyle().Colors[ImGuiCol_ModalWindowDimBg] =
        ImGui::ColorConvertU32ToFloat4(dims ? context.theme.dim : Colour());
    const std::size_t count = stack_.size();
    appeared_ = true;
    std::vector<bool> keep(count, true);
    if (count > 0) {
        drawFrom(0, context, keep);
    }
    for (std::size_t i = count; i-- > 0;) {
        if (!keep[i]) {
            std::erase(dismissed_, stack_[i].get());
            stack_.erase(stack_.begin() + static_cast<std::ptrdiff_t>(i));
            context.animate();
        }
    }
}

} // namespace forefront
