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
    PanelPlace place() const override { return PanelPlace::Drawer; }

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

    std::vector<ContextGroup> menu(Shell &context) override {
        return {context.log.entries().empty() ? ContextGroup() : ContextGroup{copyAllCommand(context)},
                actionsOf({"view.firstFault"})};
    }

  private:
    /// Draws an entry. One with a location is highlighted under the pointer, and a click anywhere on it goes there.
    void drawEntry(Shell &context, const MessageLog::Entry &entry) {
        const Diagnostic &d = entry.diagnostic;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x;
        ImDrawList &list = *ImGui::GetWindowDrawList();
        list.ChannelsSplit(2);
        list.ChannelsSetCurrent(1);
        ImGui::PushFont(context.fonts.small);
        drawWords(context, entry);
        ImGui::PopFont();
        list.ChannelsSetCurrent(0);
        const ImVec2 next = ImGui::GetCursorScreenPos();
        if (d.at) {
            const std::string name = "log/entry/" + std::to_string(entry.number);
            ImGui::SetCursorScreenPos(at);
            const bool pressed = ui::hitArea(name.c_str(), width, next.y - at.y - context.px(3));
            ui::mark(context, name);
            if (ImGui::IsItemHovered()) {
                ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
                list.AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), context.theme.hovered,
                                   context.px(4));
            }
            if (pressed) {
                context.view.goTo(*d.at, context.platform.now());
            }
            ImGui::SetCursorScreenPos(next);
        }
        list.ChannelsMerge();
        const bool inside = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(at, {at.x + width, next.y});
        if (inside && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
            openMenu(context, d);
        }
    }

    static void openMenu(Shell &context, const Diagnostic &d) {
        ContextGroup group;
        if (d.at) {
            group.push_back(
                commandOf("goTo", "Go there", [at = *d.at](Shell &c) { c.view.goTo(at, c.platform.now()); }));
        }
        group.push_back(copyCommand("copyMessage", "Copy message", toString(d)));
        context.menu.open({std::move(group), {copyAllCommand(context)}});
    }

    static ContextItem copyAllCommand(const Shell &context) {
        std::string text;
        for (const MessageLog::Entry &entry : context.log.entries()) {
            text += toString(entry.diagnostic) + '\n';
        }
        return copyCommand("copyAll", "Copy all messages", std::move(text));
    }

    static void drawWords(Workspace &context, const MessageLog::Entry &entry) {
        const Diagnostic &d = entry.diagnostic;
        const Theme &theme = context.theme;
        const bool error = d.severity == Severity::Error, warning = d.severity == Severity::Warning;
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
    }

    std::uint64_t shown_ = 0;
};

} // namespace

std::unique_ptr<Panel> makeLogPanel() {
    return std::make_unique<LogPanel>();
}

} // namespace forefront
