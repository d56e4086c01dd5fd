#include "ui/shell/help_dialogs.hpp"

#include "core/engine/base/version.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>

namespace forefront {

namespace {

class ShortcutSheet final : public Dialog {
  public:
    const char *id() const override { return "shortcuts"; }
    std::string title() const override { return "Keyboard shortcuts"; }
    float width() const override { return 860.0F; }

    bool draw(Shell &context) override {
        const float room = ImGui::GetContentRegionAvail().x;
        const float column =
            std::max((room - context.px(36)) / 3.0F, context.px(250)); // fewer columns in a narrow window
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(8), context.px(5)));
        drawColumns(context, column, room);
        ImGui::PopStyleVar();
        return true;
    }

  private:
    static void drawColumns(Shell &context, float column, float room) {
        ui::Flow flow(context, room, context.px(18));
        flow.item("tools");
        group(context, "shortcuts/tools", "Tools", column, [&] {
            for (const auto &tool : context.tools.tools) {
                const Action *const action = context.actions.find(std::string("tool.") + tool->id());
                if (action != nullptr && !action->shortcuts.empty()) {
                    row(context, column, toString(action->shortcuts.front()), tool->name());
                }
            }
        });
        flow.item("mesh");
        group(context, "shortcuts/mesh", "Mesh and timeline", column, [&] { actionRows(context, column, {"Mesh"}); });
        group(context, "shortcuts/drawing", "Drawing", column, [&] {
            for (const auto &[keys, text] : kDrawing) {
                row(context, column, keys, text);
            }
        });
        flow.item("files");
        group(context, "shortcuts/files", "Files and editing", column, [&] {
            actionRows(context, column, {"File", "Edit"});
        });
        flow.item("shapes");
        group(context, "shortcuts/shapes", "Shapes", column, [&] { actionRows(context, column, {"Shape"}); });
        group(context, "shortcuts/view", "View", column, [&] {
            row(context, column, "Wheel", "Zoom at pointer");
            row(context, column, "Space + drag", "Pan");
            row(context, column, "Middle drag", "Pan");
            actionRows(context, column, {"View", "Help"});
        });
        group(context, "shortcuts/lessons", "Lessons", column, [&] {
            row(context, column,
                "Alt+1\xe2\x80\xa6"
                "9",
                "Choose a lesson or an answer");
            row(context, column, "Alt+0", "Type an answer");
            row(context, column, "Alt+H", "Show the answer");
            actionRows(context, column, {"Learn"});
        });
    }

    static constexpr std::array<std::pair<const char *, const char *>, 8> kDrawing{{
        {"Enter", "Finish the path"},
        {"Backspace", "Remove the last node"},
        {"X Y D Q", "Type x, y, distance (diameter of a circle), angle"},
        {"0\xe2\x80\xa6"
         "9",
         "Enter a number"},
        {"Shift / Ctrl", "Constrain the angle / do not snap"},
        {"Alt + drag", "Detach from neighbours"},
        {"[ ]", "Brush radius"},
        {"Shift + [ ]", "Brush spacing"},
    }};

    template <class Rows>
    static void group(WidgetContext &context, const char *name, const char *title, float width, Rows rows) {
        ui::heading(context, title);
        rows();
        ImGui::Dummy({width, context.px(8)});
        ui::mark(context, name);
    }

    static void row(WidgetContext &context, float width, const std::string &keys, const std::string &text) {
        const float left = ImGui::GetCursorPosX();
        ImGui::TextUnformatted(keys.c_str());
        ImGui::SameLine();
        ImGui::SetCursorPosX(left + 0.36F * width);
        ui::muted(context, text);
    }

    static void actionRows(Shell &context, float width, std::initializer_list<std::string_view> menus) {
        for (const Action &action : context.actions.all()) {
            const bool wanted = std::find(menus.begin(), menus.end(), action.menu) != menus.end();
            if (!wanted || action.shortcuts.empty()) {
                continue;
            }
            std::string keys = toString(action.shortcuts.front());
            if (action.shortcuts.size() > 1 && keys.size() < 3) {
                keys += "  " + toString(action.shortcuts[1]);
            }
            row(context, width, keys, action.title);
        }
    }
};

class About final : public Dialog {
  public:
    const char *id() const override { return "about"; }
    std::string title() const override { return "Forefront"; }
    float width() const override { return 460.0F; }

    bool draw(Shell &context) override {
        ui::muted(context, std::string("Version ") + version());
        ImGui::PushTextWrapPos(0.0F);
        ImGui::TextUnformatted(
            "Triangle meshes of planar domains by S. H. Lo's advancing front technique. Draw a domain, paint the "
            "node spacing, and watch the front step forward and back.");
        ImGui::PopTextWrapPos();
        ui::small(context, "MIT licence. Built on Dear ImGui, GLFW, FreeType and Inter.", true);
        return true;
    }
};

} // namespace

std::unique_ptr<Dialog> makeShortcutSheet() {
    return std::make_unique<ShortcutSheet>();
}
std::unique_ptr<Dialog> makeAbout() {
    return std::make_unique<About>();
}

} // namespace forefront
