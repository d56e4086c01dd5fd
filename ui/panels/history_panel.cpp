#include "ui/panels/panels.hpp"
#include "ui/parts/shell.hpp"
#include "ui/style/imgui_versions.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/picture_view.hpp"

#include <imgui.h>

namespace forefront {

namespace {

/// Lists the commands of the history, the newest last. A click makes the document after that command current.
class HistoryPanel final : public Panel {
  public:
    const char *id() const override { return "history"; }
    const char *title() const override { return "History"; }
    PanelPlace place() const override { return PanelPlace::Menu; }

    void draw(Shell &context) override {
        const History &history = context.document.history();
        const bool moved = shownStep_ != context.document.step();
        shownStep_ = context.document.step();
        std::optional<std::size_t> chosen;
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
        for (std::size_t entry = 0; entry < history.size(); ++entry) {
            if (drawEntry(context, history, entry)) {
                chosen = entry;
            }
            if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
                context.menu.open({{commandOf("goTo", "Go to this state", [entry](Shell &c) { travel(c, entry); })},
                                   actionsOf({"edit.undo", "edit.redo"})});
            }
            if (moved && entry == history.position()) {
                ImGui::SetScrollHereY();
            }
        }
        ImGui::PopStyleVar();
        if (chosen) {
            travel(context, *chosen);
        }
    }

    std::vector<ContextGroup> menu(Shell &) override {
        return {{commandOf("first", "Go to the first state", [](Shell &c) { travel(c, 0); })},
                actionsOf({"edit.undo", "edit.redo"})};
    }

  private:
    static bool drawEntry(WidgetContext &context, const History &history, std::size_t entry) {
        const std::string name = "history/" + std::to_string(entry);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x, height = context.px(20);
        const bool pressed = ui::hitArea(name.c_str(), width, height);
        const bool hovered = ImGui::IsItemHovered(), here = entry == history.position();
        ui::mark(context, name);
        ImDrawList &list = *ImGui::GetWindowDrawList();
        if (here || hovered) {
            list.AddRectFilled(at, {at.x + width, at.y + height},
                               here ? context.theme.selectedRow : context.theme.hovered, context.px(4));
        }
        const Colour colour = entry > history.position() ? context.theme.faint
                              : here                     ? context.theme.text
                                                         : context.theme.muted;
        ImFont *const font = context.fonts.small;
        list.AddText(font, imgui::lineOf(*font), {at.x + context.px(8), at.y + (height - imgui::lineOf(*font)) / 2},
                     colour, history.label(entry).data(), history.label(entry).data() + history.label(entry).size());
        return pressed;
    }

    static void travel(Shell &context, std::size_t entry) {
        const std::shared_ptr<const Document> before = context.document.current();
        context.document.goTo(entry);
        keepPictureInView(context, *before);
        context.animate();
    }

    std::string shownStep_;
};

} // namespace

std::unique_ptr<Panel> makeHistoryPanel() {
    return std::make_unique<HistoryPanel>();
}

} // namespace forefront
