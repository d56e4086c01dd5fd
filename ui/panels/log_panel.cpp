#include "ui/panels/panels.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

namespace forefront {

namespace {

class LogPanel final : public Panel {
  public:
    const char *id() const override { return "log"; }
    const char *title() const override { return "Log"; }
    PanelPlace place() const override { return PanelPlace::Tabbed; }

    void draw(Shell &context) override {
        if (context.log.entries().empty()) {
            ui::small(context, "No messages yet.");
            return;
        }
        const auto &entries = context.log.entries();
        const bool news = entries.back().number != shown_;
        shown_ = entries.back().number;
        for (const MessageLog::Entry &entry : entries) {
            drawEntry(context, entry);
        }
        if (news) {
            ImGui::SetScrollHereY(1.0F);
        }
    }

  private:
    static void drawEntry(Workspace &context, const MessageLog::Entry &entry) {
        const Diagnostic &d = entry.diagnostic;
        const Theme &theme = context.theme;
        const bool error = d.severity == Severity::Error, warning = d.severity == Severity::Warning;
        ImGui::PushFont(context.fonts.small);
        ImGui::PushStyleColor(ImGuiCol_Text, error ? theme.bad : warning ? theme.warn : theme.faint);
        ImGui::TextUnformatted(error ? icon::kError : warning ? icon::kWarning : icon::kInfo);
        ImGui::PopStyleColor();
        ImGui::SameLine(context.px(20));
        std::string text = d.message;
        if (!d.file.empty()) {
            text = d.file + (d.line > 0 ? ":" + std::to_string(d.line) : "") + ": " + text;
        }
        if (!d.advice.empty()) {
            text += "; " + d.advice;
        }
        ui::wrappedText(text);
        if (d.at) {
            ImGui::SetCursorPosX(context.px(20));
            const std::string name = "log/goto/" + std::to_string(entry.number);
            const std::string label = ui::format("go to (%.6g, %.6g)", d.at->x, d.at->y);
            if (ui::link(context, name, label)) {
                context.view.goTo(*d.at, context.platform.now());
            }
        }
        ImGui::PopFont();
    }

    std::uint64_t shown_ = 0;
};

} // namespace

std::unique_ptr<Panel> makeLogPanel() {
    return std::make_unique<LogPanel>();
}

} // namespace forefront
