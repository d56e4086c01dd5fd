#include "ui/dialogs/recovery_dialog.hpp"

#include "core/drawing_files/project/project.hpp"
#include "core/files/files.hpp"
#include "ui/dialogs/recovery.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <ctime>
#include <iterator>
#include <utility>

namespace forefront {
namespace {

std::string timeText(std::time_t time) {
    std::tm parts{};
    char buffer[32] = "";
    if (::localtime_r(&time, &parts) != nullptr) {
        static_cast<void>(std::strftime(buffer, sizeof buffer, "%Y-%m-%d %H:%M:%S", &parts));
    }
    return buffer;
}

/// Returns the name of the file, or the title of a document that was never saved.
std::string nameOf(const OrphanedJournal &orphan) {
    if (!orphan.savedAt().empty()) {
        return orphan.savedAt().filename().string();
    }
    return (orphan.title().empty() ? std::string("Untitled") : orphan.title()) + " (never saved)";
}

/// Returns the number of shapes in a journal, such as "3 shapes, "; nothing if it cannot be read.
std::string shapesText(const OrphanedJournal &orphan) {
    constexpr std::size_t kLongText = 16'000'000; // takes more than a moment to read
    if (orphan.text().size() > kLongText) {
        return {};
    }
    const Result<Document> document = parseProject(orphan.text(), orphan.file().string());
    if (!document) {
        return {};
    }
    const std::size_t count = document->shapes.size();
    return ui::count(count) + (count == 1 ? " shape, " : " shapes, ");
}

} // namespace

RecoveryDialog::RecoveryDialog(Recovery &recovery, std::vector<OrphanedJournal> orphans)
    : recovery_(recovery), orphans_(std::move(orphans)) {
    std::transform(orphans_.begin(), orphans_.end(), std::back_inserter(details_),
                   [](const OrphanedJournal &orphan) { return shapesText(orphan) + timeText(orphan.written()); });
}

bool RecoveryDialog::draw(Shell &context) {
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted("Forefront closed unexpectedly. These unsaved drawings can be recovered:");
    ImGui::PopTextWrapPos();
    ImGui::Dummy({0, context.px(4)});
    const float rows = static_cast<float>(std::min<std::size_t>(orphans_.size(), 6));
    ImGui::BeginChild("orphans", {0, rows * context.px(32)}, false, ImGuiWindowFlags_NoNav);
    for (std::size_t k = 0; k < orphans_.size(); ++k) {
        const OrphanedJournal &orphan = orphans_[k];
        const std::string name = nameOf(orphan);
        if (ui::selectable(context, "dialog/recovery/item/" + std::to_string(k), name, k == chosen_, details_[k])) {
            chosen_ = k;
        }
        ui::tooltip(context, orphan.savedAt().string());
    }
    ImGui::EndChild();
    ImGui::Dummy({0, context.px(8)});
    constexpr double kWidth = 112.0;
    const bool discarded = ui::button(context, "dialog/recovery/discard", "Discard", ui::ButtonKind::Plain, true,
                                      static_cast<float>(kWidth));
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - context.px(2.0 * kWidth + 10.0));
    const bool later = ui::button(context, "dialog/recovery/later", "Ask later", ui::ButtonKind::Plain, true,
                                  static_cast<float>(kWidth));
    ImGui::SameLine(0, context.px(10));
    const bool recovered = ui::button(context, "dialog/recovery/recover", "Recover", ui::ButtonKind::Primary, true,
                                      static_cast<float>(kWidth));
    if (recovered || ui::enterPressed()) {
        return !recovery_.recover(orphans_[chosen_], context);
    }
    if (discarded) {
        orphans_[chosen_].discard();
        orphans_.erase(orphans_.begin() + static_cast<std::ptrdiff_t>(chosen_));
        details_.erase(details_.begin() + static_cast<std::ptrdiff_t>(chosen_));
        chosen_ = 0;
    }
    return !later && !orphans_.empty();
}

} // namespace forefront
