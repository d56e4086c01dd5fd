#include "ui/dialogs/file_dialog.hpp"
#include "ui/parts/shell.hpp"
#include "ui/style/imgui_versions.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace forefront {

bool FileDialog::hasNotes() const {
    return std::any_of(request_.filters.begin(), request_.filters.end(),
                       [](const FileFilter &filter) { return !filter.note.empty(); });
}

/// Returns the number of lines of the longest note, so that the dialog does not change with the chosen format.
std::ptrdiff_t FileDialog::noteLines(const Shell &context, float width) const {
    ImGui::PushFont(context.fonts.small);
    std::ptrdiff_t most = 2;
    for (const FileFilter &filter : request_.filters) {
        const std::string lines = ui::wrapped(filter.note, width);
        most = std::max(most, 1 + std::count(lines.begin(), lines.end(), '\n'));
    }
    ImGui::PopFont();
    return most;
}

float FileDialog::bottomHeight(const Shell &context) const {
    const float room = ImGui::GetContentRegionAvail().x - context.px(2.0 * kButton + 2.0 * kButtonGap);
    const float height = ImGui::CalcTextSize(ui::wrapped(warning(), room).c_str(), nullptr, false, room).y;
    float more = std::max(0.0F, height - ImGui::GetTextLineHeight());
    constexpr int kPlain = 84, kLine = 34;
    const int lines = (!request_.extra       ? 0
                       : request_.extraLines ? request_.extraLines(filter())
                                             : 1) +
                      (request_.presets.empty() ? 0 : presetRows_) + (hasNotes() ? 1 : 0);
    if (hasNotes()) {
        const float width = ImGui::GetContentRegionMax().x - context.px(kNoteIndent);
        more += static_cast<float>(noteLines(context, width) - 2) * imgui::lineOf(*context.fonts.small);
    }
    return context.px(kPlain + lines * kLine) + more;
}

/// Returns the preset of the chosen filter: that which was pressed, if several share the filter; else one for files
/// with the same extension. Null if there is none.
const FilePreset *FileDialog::chosenPreset() const {
    const auto filterOf = [this](const FilePreset &preset) {
        return std::find_if(request_.filters.begin(), request_.filters.end(),
                            [&](const FileFilter &each) { return each.id == preset.filter; });
    };
    const FilePreset *same = nullptr, *similar = nullptr;
    for (const FilePreset &preset : request_.presets) {
        if (preset.filter == filter().id && (same == nullptr || preset.id == preset_)) {
            same = &preset;
        }
        if (const auto its = filterOf(preset); similar == nullptr && its != request_.filters.end() &&
                                               !its->extensions.empty() && its->extensions == filter().extensions) {
            similar = &preset;
        }
    }
    return same != nullptr ? same : similar;
}

/// Draws the buttons of the presets; the chosen one is filled.
void FileDialog::drawPresets(Shell &context) {
    ImGui::AlignTextToFramePadding();
    ui::muted(context, "For");
    ImGui::SameLine(context.px(72));
    ImGui::BeginGroup(); // further rows begin below the first button
    ui::Flow flow(context, ImGui::GetContentRegionAvail().x, context.px(6));
    const FilePreset *const chosen = chosenPreset();
    for (const FilePreset &preset : request_.presets) {
        flow.item(preset.id.c_str());
        if (ui::chip(context, widget("preset/") + preset.id, preset.label, &preset == chosen)) {
            preset_ = preset.id;
            const auto wanted = std::find_if(request_.filters.begin(), request_.filters.end(),
                                             [&](const FileFilter &f) { return f.id == preset.filter; });
            useFilter(static_cast<std::size_t>(wanted - request_.filters.begin()));
            focusName_ = true; // the name is what is typed next
        }
    }
    flow.finish();
    ImGui::EndGroup();
    presetRows_ = static_cast<int>(std::lround(ImGui::GetItemRectSize().y / ImGui::GetFrameHeightWithSpacing()));
}

void FileDialog::drawNote(Shell &context) {
    const float width = ImGui::GetContentRegionMax().x - context.px(kNoteIndent);
    const std::ptrdiff_t lines = noteLines(context, width);
    ImGui::SetCursorPosX(context.px(kNoteIndent));
    ImGui::PushFont(context.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, context.theme.muted);
    const float below = ImGui::GetCursorPosY() + static_cast<float>(lines) * ImGui::GetTextLineHeight();
    ImGui::TextUnformatted(ui::wrapped(filter().note, width).c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
    ui::mark(context, widget("note"));
    ImGui::SetCursorPosY(below + ImGui::GetStyle().ItemSpacing.y);
}

void FileDialog::drawFolder(Shell &context) {
    ImGui::AlignTextToFramePadding();
    ui::muted(context, "Folder");
    ImGui::SameLine(context.px(kNoteIndent));
    const float button = context.px(100);
    const std::string whole = folder_.string();
    const bool fits = ImGui::CalcTextSize(whole.c_str()).x < ImGui::GetContentRegionAvail().x - button;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(fits ? whole.c_str() : ("\xe2\x80\xa6/" + folder_.filename().string()).c_str());
    ui::mark(context, widget("folder"));
    ui::tooltip(context, whole);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - button);
    if (ui::button(context, widget("browse"), "Browse\xe2\x80\xa6", ui::ButtonKind::Plain, true, 100.0F)) {
        browses_ = true;
        context.animate();
    }
}

} // namespace forefront
