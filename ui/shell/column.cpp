#include "ui/parts/shown_panels.hpp"
#include "ui/shell/cut_edges.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/shell/section_heights.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront::shell {

namespace {

/// Draws an upright edge that can be dragged. Returns the distance dragged in this frame, in pixels.
float splitter(WidgetContext &context, const char *name, const PixelRect &rect) {
    // Dear ImGui clips at half of the padding, which would hide the edge.
    const ImVec2 corner{static_cast<float>(rect.x), static_cast<float>(rect.y)};
    ImGui::PushClipRect(corner, {static_cast<float>(rect.x + rect.width), static_cast<float>(rect.y + rect.height)},
                        false);
    ImGui::SetCursorScreenPos(corner);
    ui::hitArea(name, static_cast<float>(rect.width), static_cast<float>(rect.height));
    ui::mark(context, name);
    const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
    if (lit) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
        const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
        const float middle = (min.x + max.x) / 2, half = context.px(1);
        ImGui::GetWindowDrawList()->AddRectFilled({middle - half, min.y}, {middle + half, max.y},
                                                  fade(context.theme.accent, 0.8));
    }
    ImGui::PopClipRect();
    return ImGui::IsItemActive() ? ImGui::GetIO().MouseDelta.x : 0.0F;
}

constexpr double kLowestInLesson = 172.0; ///< seven rows, so that few panels show what the page is about
constexpr double kSectionHeading = 28.0, kSectionGap = 10.0, kLowestSection = 84.0, kColumnPad = 12.0; // design pixels

/// Draws the heading of a section, which folds it.
void sectionHeading(Shell &context, const Panel &panel, bool open) {
    const std::string name = std::string("panel/") + panel.id();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = context.px(kSectionHeading);
    if (ui::hitArea(name.c_str(), width, height)) {
        setFolded(context, panel.id(), open);
        if (!open && context.lessons.open) {
            showPanel(context, panel.id()); // gets room like the panels of the page
        }
    }
    const bool hovered = ImGui::IsItemHovered();
    ui::mark(context, name);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const float pad = context.px(kColumnPad);
    list.AddLine({at.x - pad, at.y}, {at.x + width + pad, at.y}, context.theme.line);
    ImGui::PushFont(context.fonts.heading);
    const float y = at.y + (height - ImGui::GetFontSize()) / 2;
    list.AddText({at.x - context.px(2), y}, hovered ? context.theme.text : context.theme.muted,
                 open ? icon::kDown : icon::kRight);
    list.AddText({at.x + context.px(18), y}, context.theme.text, panel.title());
    if (context.settings.pinned.contains(panel.id())) {
        const float mark = ImGui::CalcTextSize(icon::kPin).x;
        list.AddText({at.x + width - mark, y}, context.theme.muted, icon::kPin);
    }
    ImGui::PopFont();
}

/// Returns switches that add the panels of the column to this workspace or remove them.
ContextGroup panelSwitches(const Shell &context) {
    ContextGroup group{headingOf(std::string("Panels in ") + presetOf(context.settings.workspace).name)};
    for (const auto &panel : context.panels) {
        if (panel->place() == PanelPlace::Column) {
            const std::string id = panel->id();
            const bool on = belongsHere(context, id);
            group.push_back(
                switchOf("panel/show/" + id, panel->title(), on, [id, on](Shell &c) { setShown(c, id, !on); }));
        }
    }
    return group;
}

/// Returns the commands on the section of a panel itself.
ContextGroup sectionCommands(const Shell &context, const std::vector<Panel *> &panels, std::size_t index, bool open) {
    const std::string id = panels[index]->id();
    const bool pinned = context.settings.pinned.contains(id);
    const auto swap = [](std::string from, std::string before) {
        return [from = std::move(from), before = std::move(before)](Shell &c) { movePanel(c, from, before); };
    };
    ContextGroup group;
    group.push_back(
        commandOf("panel/fold", open ? "Fold" : "Unfold", [id, open](Shell &c) { setFolded(c, id, open); }));
    group.push_back(switchOf("panel/pin", "Show in all workspaces", pinned, [id, pinned](Shell &c) {
        pinned ? static_cast<void>(c.settings.pinned.erase(id)) : static_cast<void>(c.settings.pinned.insert(id));
        c.animate();
    }));
    if (index > 0) {
        group.push_back(commandOf("panel/up", "Move up", swap(id, panels[index - 1]->id())));
    }
    if (index + 1 < panels.size()) {
        group.push_back(commandOf("panel/down", "Move down", swap(panels[index + 1]->id(), id)));
    }
    group.push_back(commandOf("panel/hide", "Hide", [id](Shell &c) { setShown(c, id, false); }));
    return group;
}

ContextGroup columnCommands() {
    return {commandOf("panel/reset", "Reset panels of this workspace",
                      [](Shell &c) {
                          changesOf(c).panels.clear();
                          changesOf(c).folded.clear();
                          changesOf(c).order.clear();
                          c.called.clear();
                          c.animate();
                      }),
            actionOf("view.panels")};
}

/// Returns true if the right button was clicked between `top` and `bottom`, and no row there has opened a menu.
bool asksForMenu(const Shell &context, float top, float bottom) {
    const float y = ImGui::GetMousePos().y;
    return ImGui::IsMouseClicked(ImGuiMouseButton_Right) && y >= top && y < bottom &&
           ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows) && !context.menu.opens &&
           !context.widgets.fields.clicked;
}

/// Opens the menu of a section: on its heading that of the column too, else the commands of its panel first.
void openSectionMenu(Shell &context, const std::vector<Panel *> &panels, std::size_t index, bool open, bool onHeading) {
    std::vector<ContextGroup> groups = panels[index]->menu(context);
    ContextGroup own = sectionCommands(context, panels, index, open);
    if (onHeading) {
        groups.insert(groups.begin(), std::move(own));
        groups.push_back(panelSwitches(context));
        groups.push_back(columnCommands());
    } else {
        own.push_back(actionOf("view.panels"));
        groups.push_back(std::move(own));
    }
    context.menu.open(std::move(groups));
}

/// Returns a number that nearly always differs between selections.
int keyOf(const Selection &selection) {
    std::size_t key = selection.size();
    const auto add = [&key](std::size_t value) { key = key * 1'000'003U + value + 1U; };
    if (!selection.shapes.empty()) {
        add(*selection.shapes.begin());
    }
    if (!selection.nodes.empty()) {
        add(selection.nodes.begin()->shape);
        add(selection.nodes.begin()->node);
    }
    if (!selection.segments.empty()) {
        add(selection.segments.begin()->shape);
        add(selection.segments.begin()->segment);
    }
    if (!selection.sources.empty()) {
        add(*selection.sources.begin());
    }
    if (!selection.markers.empty()) {
        add(*selection.markers.begin());
    }
    if (!selection.constraints.empty()) {
        add(*selection.constraints.begin());
    }
    if (!selection.faces.empty()) {
        add(std::hash<double>()(selection.faces.begin()->x));
    }
    return static_cast<int>(key % 1'000'000'007U);
}

/// Shows the inspector when something else is selected.
void followSelection(Shell &context) {
    int &seen = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("selection"), 0);
    const int now = keyOf(context.selection);
    if (now != seen && !context.selection.empty() && belongsHere(context, "inspector") &&
        !isFolded(context, "inspector")) {
        context.revealedPanel = "inspector";
    }
    seen = now;
}

/// Gives the next window the width of its content with a scroll bar, whether or not it has one. Otherwise a bar that
/// comes would wrap texts, and these would make it go again, for ever.
void reserveScrollbar(float width) {
    ImGui::SetNextWindowContentSize({std::max(1.0F, width - ImGui::GetStyle().ScrollbarSize), 0.0F});
}

/// Draws the content of a panel in `height` pixels and returns its whole height.
float drawContent(Shell &context, Panel &panel, float height, float known) {
    const bool whole = known <= height + 1.0F;
    const float width = ImGui::GetContentRegionAvail().x;
    reserveScrollbar(width);
    ImGui::BeginChild(panel.id(), {width, height}, false,
                      ImGuiWindowFlags_NoNav |
                          (whole ? ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoScrollbar : 0));
    panel.draw(context);
    const float used = ImGui::GetCursorPosY();
    if (!whole) {
        shadeCutEdges(context);
    }
    ImGui::EndChild();
    return used;
}

/// Returns the sections of the panels; the heights of their contents are those of the last frame.
std::vector<Section> sectionsOf(const Shell &context, const std::vector<Panel *> &panels) {
    ImGuiStorage &storage = *ImGui::GetStateStorage();
    std::vector<Section> sections;
    for (const Panel *panel : panels) {
        // In a lesson, what the user opened outside of it must not take the room of what the page is about.
        const bool opened = !context.lessons.open && changesOf(context).folded.contains(panel->id());
        const bool called =
            std::find(context.called.begin(), context.called.end(), panel->id()) != context.called.end();
        const bool selected = !context.selection.empty() && std::string_view(panel->id()) == "inspector";
        sections.push_back({.open = !isFolded(context, panel->id()),
                            .keepsOpen = called || selected || opened || context.revealedPanel == panel->id(),
                            .first = called,
                            .content = storage.GetFloat(ImGui::GetID(panel->id()))});
    }
    return sections;
}

void drawSections(Shell &context) {
    followSelection(context);
    const std::vector<Panel *> panels = columnPanels(context);
    std::vector<Section> sections = sectionsOf(context, panels);
    const bool lesson = context.lessons.open.has_value(); // its pages speak of what they call
    const float room = ImGui::GetContentRegionAvail().y;
    const bool roomy = lesson && room > 3.0F * context.px(kLowestInLesson);
    const SectionMeasures measures{context.px(kSectionHeading), context.px(kSectionGap),
                                   context.px(roomy ? kLowestInLesson : kLowestSection), lesson};
    const std::vector<float> heights = sectionHeights(sections, measures, room);
    float y = 0.0F;
    for (std::size_t k = 0; k < panels.size(); ++k) {
        ImGui::SetCursorPosY(y);
        const float top = ImGui::GetCursorScreenPos().y, below = top + measures.heading;
        if (context.revealedPanel == panels[k]->id()) {
            ImGui::SetScrollFromPosY(top - ImGui::GetWindowPos().y, 0.0F);
            context.revealedPanel.clear();
            context.animate();
        }
        ImGui::PushID(panels[k]->id());
        sectionHeading(context, *panels[k], sections[k].open);
        ImGui::PopID();
        y += measures.heading;
        if (sections[k].open) {
            ImGui::SetCursorPosY(y);
            const float used = drawContent(context, *panels[k], heights[k], sections[k].content);
            if (std::abs(used - sections[k].content) > 0.5F) {
                ImGui::GetStateStorage()->SetFloat(ImGui::GetID(panels[k]->id()), used);
                context.animate();
            }
            y += heights[k] + measures.gap;
        }
        const float bottom = top + (sections[k].open ? measures.heading + heights[k] + measures.gap : measures.heading);
        if (asksForMenu(context, top, bottom)) {
            openSectionMenu(context, panels, k, sections[k].open, ImGui::GetMousePos().y < below);
        }
    }
    ImGui::SetCursorPosY(y);
    ImGui::Dummy({0, 0});
    if (asksForMenu(context, ImGui::GetItemRectMin().y, 1e9F)) {
        context.menu.open({panelSwitches(context), columnCommands()});
    }
}

} // namespace

void drawColumn(Shell &context, const PixelRect &rect) {
    if (rect.width < 1.0 || rect.height < 1.0) {
        return; // hidden, or the window is too low for anything between the bars
    }
    beginRegion("##column", rect, context.theme.panel, context.px(kColumnPad), 0);
    const float edge = static_cast<float>(rect.x);
    const ImVec2 end{static_cast<float>(rect.x + rect.width), static_cast<float>(rect.y + rect.height)};
    ImGui::PushClipRect({edge, static_cast<float>(rect.y)}, end, false); // scroll bars lie in the padding
    const float sections = end.x - ImGui::GetCursorScreenPos().x;
    reserveScrollbar(sections);
    ImGui::BeginChild("sections", {sections, 0}, false, ImGuiWindowFlags_NoNav);
    drawSections(context);
    ImGui::EndChild();
    ImGui::PopClipRect();
    ui::markWindow(context, "column");
    ImGui::GetWindowDrawList()->AddLine({edge, static_cast<float>(rect.y)},
                                        {edge, static_cast<float>(rect.y + rect.height)}, context.theme.line);
    const double scale = static_cast<double>(context.scale);
    const float wider = splitter(context, "splitter/column", {rect.x, rect.y, 6.0 * scale, rect.height});
    if (wider != 0.0F) {
        context.settings.panelWidth =
            std::clamp((rect.width - static_cast<double>(wider)) / scale, kMinPanelWidth, kMaxPanelWidth);
    }
    ImGui::End();
}

} // namespace forefront::shell
