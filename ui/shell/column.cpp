#include "ui/shell/shell.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace forefront::shell {

namespace {

/// Draws an edge that can be dragged. Returns the distance dragged in this frame, in pixels along its normal.
float splitter(WidgetContext &context, const char *name, const PixelRect &rect, bool vertical) {
    // Dear ImGui clips at half of the padding, which would hide the edge.
    const ImVec2 corner{static_cast<float>(rect.x), static_cast<float>(rect.y)};
    ImGui::PushClipRect(corner, {static_cast<float>(rect.x + rect.width), static_cast<float>(rect.y + rect.height)},
                        false);
    ImGui::SetCursorScreenPos(corner);
    ImGui::InvisibleButton(name, {static_cast<float>(rect.width), static_cast<float>(rect.height)});
    ui::mark(context, name);
    const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
    if (lit) {
        ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
        const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
        const ImVec2 middle{(min.x + max.x) / 2, (min.y + max.y) / 2};
        const float half = context.px(1);
        ImGui::GetWindowDrawList()->AddRectFilled(
            vertical ? ImVec2(middle.x - half, min.y) : ImVec2(min.x, middle.y - half),
            vertical ? ImVec2(middle.x + half, max.y) : ImVec2(max.x, middle.y + half),
            fade(context.theme.accent, 0.8));
    }
    ImGui::PopClipRect();
    if (!ImGui::IsItemActive()) {
        return 0.0F;
    }
    return vertical ? ImGui::GetIO().MouseDelta.x : ImGui::GetIO().MouseDelta.y;
}

/// Returns true if the user folded a panel, or if it leaves its room to others in a low window; lessons point at it.
bool isFolded(const Shell &context, const Panel &panel) {
    constexpr double kLowWindow = 900.0; // design pixels
    const double height = context.platform.framebufferSize().height / static_cast<double>(context.scale);
    const auto chosen = context.settings.folded.find(panel.id());
    if (chosen != context.settings.folded.end()) {
        return chosen->second;
    }
    return panel.foldsInLowWindow() && height < kLowWindow && !context.lessons.visible;
}

/// Draws the heading of a panel, which folds it. Returns true if the panel is unfolded.
bool panelHeading(Shell &context, const Panel &panel) {
    const std::string name = std::string("panel/") + panel.id();
    const bool folded = isFolded(context, panel);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = context.px(22);
    if (ImGui::InvisibleButton(name.c_str(), {width, height})) {
        context.settings.folded[panel.id()] = !folded;
    }
    const bool hovered = ImGui::IsItemHovered();
    ui::mark(context, name);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    ImGui::PushFont(context.fonts.heading);
    const float y = at.y + (height - ImGui::GetFontSize()) / 2;
    const Colour colour = hovered ? context.theme.text : context.theme.muted;
    list.AddText({at.x, y}, colour, folded ? icon::kRight : icon::kDown);
    list.AddText({at.x + context.px(14), y}, colour, panel.title());
    ImGui::PopFont();
    return !folded;
}

/// Opens the menu of a panel for a right click between `top` and `bottom`, unless a row of it has opened its own.
void panelMenu(Shell &context, Panel &panel, float top, float bottom) {
    const float y = ImGui::GetMousePos().y;
    const bool clicked = ImGui::IsMouseClicked(ImGuiMouseButton_Right) && y >= top && y < bottom &&
                         ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows);
    if (!clicked || context.menu.opens) {
        return;
    }
    std::vector<ContextGroup> groups = panel.menu(context);
    ContextGroup own;
    if (panel.place() == PanelPlace::Stacked) {
        const bool folded = isFolded(context, panel);
        own.push_back(commandOf("fold", folded ? "Unfold" : "Fold",
                                [id = std::string(panel.id()), folded](Shell &c) { c.settings.folded[id] = !folded; }));
    }
    own.push_back(actionOf("view.panels"));
    groups.push_back(std::move(own));
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
    return static_cast<int>(key % 1'000'000'007U);
}

/// Scrolls to the inspector, which is drawn next, when something else is selected and there is room for little else.
void showSelection(const Shell &context, float height) {
    constexpr double kLowStack = 300.0; // design pixels
    int &seen = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("selection"), 0);
    const int now = keyOf(context.selection);
    if (now != seen && !context.selection.empty() && height < context.px(kLowStack)) {
        ImGui::SetScrollFromPosY(ImGui::GetCursorScreenPos().y - ImGui::GetWindowPos().y, 0.0F);
    }
    seen = now;
}

void drawStacked(Shell &context, float height) {
    ImGui::BeginChild("stacked", {0, height}, false, ImGuiWindowFlags_NoNav);
    bool first = true;
    for (const auto &panel : context.panels) {
        if (panel->place() != PanelPlace::Stacked) {
            continue;
        }
        ImGui::PushID(panel->id());
        if (!first) {
            ImGui::Dummy({0, context.px(2)});
            const ImVec2 at = ImGui::GetCursorScreenPos();
            ImGui::GetWindowDrawList()->AddLine({at.x - context.px(12), at.y},
                                                {at.x + ImGui::GetContentRegionAvail().x + context.px(12), at.y},
                                                context.theme.line);
            ImGui::Dummy({0, context.px(1)});
        }
        first = false;
        if (std::string_view(panel->id()) == "inspector") {
            showSelection(context, height);
        }
        const float top = ImGui::GetCursorScreenPos().y;
        if (panelHeading(context, *panel)) {
            if (panel->height() > 0.0) {
                ImGui::BeginChild("content", {0, context.px(panel->height())}, false, ImGuiWindowFlags_NoNav);
                panel->draw(context);
                ImGui::EndChild();
            } else {
                panel->draw(context);
            }
        }
        panelMenu(context, *panel, top, ImGui::GetCursorScreenPos().y);
        ImGui::PopID();
    }
    ImGui::EndChild();
}

std::vector<Panel *> tabsOf(const Shell &context) {
    std::vector<Panel *> tabs;
    for (const auto &panel : context.panels) {
        if (panel->place() == PanelPlace::Tabbed) {
            tabs.push_back(panel.get());
        }
    }
    return tabs;
}

/// Returns the index of the panel shown in the tabs.
std::size_t chosenTab(const Shell &context, const std::vector<Panel *> &tabs) {
    const auto last =
        std::find_if(tabs.begin(), tabs.end(), [&](const Panel *tab) { return tab->id() == context.settings.tab; });
    return last == tabs.end() ? 0 : static_cast<std::size_t>(last - tabs.begin());
}

const Panel *shownTab(const Shell &context) {
    const std::vector<Panel *> tabs = tabsOf(context);
    return tabs.empty() ? nullptr : tabs[chosenTab(context, tabs)];
}

/// Returns the height of the tabs in design pixels, after the user has dragged their edge up by `change`. A panel with
/// a height of its own does not change that of the others.
double tabsHeight(Shell &context, double change = 0.0) {
    const Panel *const shown = shownTab(context);
    const bool own = shown != nullptr && shown->tabHeight() > 0.0;
    auto &heights = context.settings.tabHeights;
    const auto known = own ? heights.find(shown->id()) : heights.end();
    const double before = known != heights.end() ? known->second
                          : own                  ? shown->tabHeight()
                                                 : context.settings.tabsHeight;
    const double after = std::clamp(before + change, kMinTabs, kMaxTabs);
    if (change != 0.0) {
        (own ? heights[shown->id()] : context.settings.tabsHeight) = after;
    }
    return after;
}

void drawTabs(Shell &context) {
    const std::vector<Panel *> tabs = tabsOf(context);
    if (tabs.empty()) {
        return;
    }
    std::size_t chosen = chosenTab(context, tabs);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    ImGui::PushFont(context.fonts.heading);
    constexpr double kLowTabs = 200.0; // design pixels; the rows of headings leave room to the tab
    const bool low = ImGui::GetContentRegionAvail().y < context.px(kLowTabs);
    const float height = context.px(low ? 20 : 24);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                        {ImGui::GetStyle().ItemSpacing.x, low ? 0.0F : ImGui::GetStyle().ItemSpacing.y});
    float words = 0.0F;
    for (const Panel *tab : tabs) {
        words += ImGui::CalcTextSize(tab->title()).x + context.px(2);
    }
    const float room = ImGui::GetContentRegionAvail().x - words;
    const float gap =
        std::clamp(room / std::max(1.0F, static_cast<float>(tabs.size()) - 1.0F), context.px(5), context.px(16));
    for (std::size_t i = 0; i < tabs.size(); ++i) {
        const std::string title = tabs[i]->title();
        const ImVec2 size = ImGui::CalcTextSize(title.c_str());
        if (i > 0) { // in a narrow column the tabs take a second row
            ImGui::SameLine(0, gap);
            if (ImGui::GetContentRegionAvail().x < size.x) {
                ImGui::NewLine();
            }
        }
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const std::string name = std::string("panel/") + tabs[i]->id();
        if (ImGui::InvisibleButton(name.c_str(), {size.x + context.px(2), height})) {
            chosen = i;
            context.settings.tab = tabs[i]->id();
        }
        ui::mark(context, name);
        const bool here = chosen == i;
        const Colour colour = here || ImGui::IsItemHovered() ? context.theme.text : context.theme.muted;
        list.AddText({at.x, at.y + (height - size.y) / 2}, colour, title.c_str());
        if (here) {
            list.AddRectFilled({at.x, at.y + height - context.px(2)}, {at.x + size.x, at.y + height},
                               context.theme.accent, context.px(1));
        }
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
    ImGui::BeginChild("tabcontent", {0, 0}, false, ImGuiWindowFlags_NoNav);
    tabs[chosen]->draw(context);
    const float top = ImGui::GetWindowPos().y;
    panelMenu(context, *tabs[chosen], top, top + ImGui::GetWindowHeight());
    ImGui::EndChild();
}

} // namespace

void drawColumn(Shell &context, const PixelRect &rect) {
    if (rect.width < 1.0 || rect.height < 1.0) {
        return; // hidden, or the window is too low for anything between the bars
    }
    beginRegion("##column", rect, context.theme.panel, context.px(12), context.px(6));
    const float edge = static_cast<float>(rect.x);
    ImGui::GetWindowDrawList()->AddLine({edge, static_cast<float>(rect.y)},
                                        {edge, static_cast<float>(rect.y + rect.height)}, context.theme.line);
    const double scale = static_cast<double>(context.scale);
    // In a low window the panels above the tabs keep more than half of the column, unless the tabs show a long list.
    const double share = shownTab(context) != nullptr && shownTab(context)->tabHeight() > 0.0 ? 0.66 : 0.4;
    const double limit =
        std::min(rect.height - 80.0 * scale, std::max(share * rect.height, rect.height - 240.0 * scale));
    const double tabs = std::clamp(tabsHeight(context) * scale, 60.0, std::max(60.0, limit));
    const float stacked = static_cast<float>(rect.height - tabs) - context.px(10);
    drawStacked(context, stacked);
    const double splitY = rect.y + rect.height - tabs - 5.0 * scale;
    const float line = static_cast<float>(splitY + 3.0 * scale);
    ImGui::GetWindowDrawList()->AddLine({edge, line}, {edge + static_cast<float>(rect.width), line},
                                        context.theme.line);
    const float dragged =
        splitter(context, "splitter/tabs", {rect.x + 6 * scale, splitY, rect.width - 6 * scale, 6.0 * scale}, false);
    tabsHeight(context, -static_cast<double>(dragged) / scale);
    ImGui::SetCursorScreenPos({edge + context.px(12), line + context.px(3)});
    ImGui::BeginChild("tabs", {static_cast<float>(rect.width) - context.px(24), 0}, false, ImGuiWindowFlags_NoNav);
    drawTabs(context);
    ImGui::EndChild();
    const float wider = splitter(context, "splitter/column", {rect.x, rect.y, 6.0 * scale, rect.height}, true);
    context.settings.panelWidth =
        std::clamp(context.settings.panelWidth - static_cast<double>(wider) / scale, 240.0, 640.0);
    ImGui::End();
}

} // namespace forefront::shell
