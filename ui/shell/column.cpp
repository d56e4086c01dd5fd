#include "ui/shell/main_window.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
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
    list.AddText({at.x - context.px(2), y}, colour, folded ? icon::kRight : icon::kDown);
    list.AddText({at.x + context.px(18), y}, context.theme.text, panel.title());
    ImGui::PopFont();
    return !folded;
}

/// Opens the menu of a panel for a right click between `top` and `bottom`, unless a row of it has opened its own.
void panelMenu(Shell &context, Panel &panel, float top, float bottom) {
    const float y = ImGui::GetMousePos().y;
    const bool clicked = ImGui::IsMouseClicked(ImGuiMouseButton_Right) && y >= top && y < bottom &&
                         ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows);
    if (!clicked || context.menu.opens || context.widgets.fields.clicked) {
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

/// Returns the panels with tabs, hidden or not, in the order that the user gave them.
std::vector<Panel *> orderedTabs(const Shell &context) {
    std::vector<Panel *> tabs;
    for (const auto &panel : context.panels) {
        if (panel->place() == PanelPlace::Tabbed) {
            tabs.push_back(panel.get());
        }
    }
    const std::vector<std::string> &order = context.settings.tabOrder;
    std::stable_sort(tabs.begin(), tabs.end(), [&order](const Panel *a, const Panel *b) {
        return std::find(order.begin(), order.end(), a->id()) < std::find(order.begin(), order.end(), b->id());
    });
    return tabs;
}

/// Returns the panels whose tabs are shown. A hidden one is shown while something has chosen it, such as a lesson.
std::vector<Panel *> tabsOf(const Shell &context) {
    std::vector<Panel *> tabs = orderedTabs(context);
    std::erase_if(tabs, [&context](const Panel *tab) {
        return context.settings.hiddenTabs.contains(tab->id()) && tab->id() != context.settings.tab;
    });
    return tabs.empty() ? orderedTabs(context) : tabs;
}

/// Returns the index of the panel shown in the tabs.
std::size_t chosenTab(const Shell &context, const std::vector<Panel *> &tabs) {
    const auto last =
        std::find_if(tabs.begin(), tabs.end(), [&](const Panel *tab) { return tab->id() == context.settings.tab; });
    return last == tabs.end() ? 0 : static_cast<std::size_t>(last - tabs.begin());
}

/// Moves a tab in front of another one.
void moveTab(Shell &context, const std::string &from, const std::string &before) {
    std::vector<std::string> order;
    for (const Panel *tab : orderedTabs(context)) {
        if (tab->id() == before) {
            order.push_back(from);
        }
        if (tab->id() != from) {
            order.emplace_back(tab->id());
        }
    }
    context.settings.tabOrder = std::move(order);
}

/// Opens the menu of the tab at an index: it hides or moves the tab, and shows or hides others.
void openTabMenu(Shell &context, const std::vector<Panel *> &tabs, std::size_t index) {
    const std::string id = tabs[index]->id();
    const auto swap = [](std::string from, std::string before) {
        return [from = std::move(from), before = std::move(before)](Shell &c) { moveTab(c, from, before); };
    };
    ContextGroup own, shown{headingOf("Tabs")};
    if (index > 0) {
        own.push_back(commandOf("tab/left", "Move left", swap(id, tabs[index - 1]->id())));
    }
    if (index + 1 < tabs.size()) {
        own.push_back(commandOf("tab/right", "Move right", swap(tabs[index + 1]->id(), id)));
    }
    for (const Panel *tab : orderedTabs(context)) {
        const std::string other = tab->id();
        const bool on = !context.settings.hiddenTabs.contains(other);
        if (on && tabs.size() == 1) {
            continue; // the last one stays
        }
        shown.push_back(switchOf("tab/show/" + other, tab->title(), on, [other, on](Shell &c) {
            on ? static_cast<void>(c.settings.hiddenTabs.insert(other))
               : static_cast<void>(c.settings.hiddenTabs.erase(other));
            c.settings.tab = on && c.settings.tab == other ? std::string() : c.settings.tab;
        }));
    }
    ContextGroup reset{commandOf("tab/reset", "Show all tabs",
                                 [](Shell &c) {
                                     c.settings.hiddenTabs.clear();
                                     c.settings.tabOrder.clear();
                                 }),
                       actionOf("view.panels")};
    context.menu.open({std::move(own), std::move(shown), std::move(reset)});
}

/// Divides tabs of these widths into as few rows as fit into `room`, of about equal width. Returns the first tab of
/// each row, and the number of tabs.
std::vector<std::size_t> rowsOf(const std::vector<float> &widths, float room) {
    const auto divide = [&widths](float limit) {
        std::vector<std::size_t> firsts{0};
        float used = 0.0F;
        for (std::size_t i = 0; i < widths.size(); ++i) {
            if (used > 0.0F && used + widths[i] > limit) {
                firsts.push_back(i);
                used = 0.0F;
            }
            used += widths[i];
        }
        firsts.push_back(widths.size());
        return firsts;
    };
    const std::size_t fewest = divide(room).size();
    float low = 0.0F, high = room; // bisect for the narrowest rows; else the last one may hold a single tab
    for (int k = 0; k < 12; ++k) {
        const float middle = (low + high) / 2.0F;
        (divide(middle).size() <= fewest ? high : low) = middle;
    }
    return divide(high);
}

/// Draws a tab. Returns true if it was clicked.
bool drawTab(Shell &context, const Panel &tab, const PixelRect &rect, bool chosen) {
    const std::string name = std::string("panel/") + tab.id();
    const ImVec2 min{static_cast<float>(rect.x), static_cast<float>(rect.y)};
    const ImVec2 max{min.x + static_cast<float>(rect.width), min.y + static_cast<float>(rect.height)};
    ImGui::SetCursorScreenPos(min);
    const bool clicked =
        ImGui::InvisibleButton(name.c_str(), {static_cast<float>(rect.width), static_cast<float>(rect.height)});
    const bool hovered = ImGui::IsItemHovered();
    ui::mark(context, name);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const Theme &theme = context.theme;
    list.AddRectFilled(min, max,
                       chosen    ? theme.pressed
                       : hovered ? theme.hovered
                                 : theme.raised,
                       context.px(3), ImDrawFlags_RoundCornersTop);
    if (chosen) {
        list.AddRectFilled({min.x, max.y - context.px(2)}, max, theme.accent);
    }
    const ImVec2 size = ImGui::CalcTextSize(tab.title());
    list.AddText({std::round((min.x + max.x - size.x) / 2), std::round((min.y + max.y - size.y) / 2)},
                 chosen || hovered ? theme.text : theme.muted, tab.title());
    return clicked;
}

/// Draws the tabs in rows that are filled, and returns the index of the chosen one.
std::size_t drawTabRows(Shell &context, const std::vector<Panel *> &tabs) {
    std::size_t chosen = chosenTab(context, tabs);
    ImGui::PushFont(context.fonts.small);
    constexpr double kLowTabs = 200.0; // design pixels; the rows of headings leave room to the tab
    const bool low = ImGui::GetContentRegionAvail().y < context.px(kLowTabs);
    const float height = context.px(low ? 15 : 22), gap = context.px(1);
    std::vector<float> widths;
    widths.reserve(tabs.size());
    for (const Panel *tab : tabs) {
        widths.push_back(ImGui::CalcTextSize(tab->title()).x + context.px(3) + gap);
    }
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float room = ImGui::GetContentRegionAvail().x + gap;
    const std::vector<std::size_t> rows = rowsOf(widths, room);
    float y = at.y;
    for (std::size_t row = 0; row + 1 < rows.size(); ++row) {
        const auto first = widths.begin() + static_cast<std::ptrdiff_t>(rows[row]);
        const auto last = widths.begin() + static_cast<std::ptrdiff_t>(rows[row + 1]);
        const float wider = (room - std::accumulate(first, last, 0.0F)) / static_cast<float>(last - first);
        float x = at.x;
        for (std::size_t i = rows[row]; i < rows[row + 1]; ++i) {
            const float width = std::max(widths[i] + wider - gap, 1.0F);
            if (drawTab(context, *tabs[i], {x, y, width, height}, chosen == i)) {
                chosen = i;
                context.settings.tab = tabs[i]->id();
            }
            if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
                openTabMenu(context, tabs, i);
            }
            x += width + gap;
        }
        y += height + gap;
    }
    ImGui::PopFont();
    ImGui::SetCursorScreenPos({at.x, y + gap});
    return chosen;
}

void drawTabs(Shell &context) {
    const std::vector<Panel *> tabs = tabsOf(context);
    if (tabs.empty()) {
        return;
    }
    const std::size_t chosen = drawTabRows(context, tabs);
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
    // In a low window the panels above the tabs keep nearly half of the column. The height is the same for all tabs, so
    // that they stay under the pointer that chooses one.
    const double limit =
        std::min(rect.height - 80.0 * scale, std::max(0.56 * rect.height, rect.height - 240.0 * scale));
    const double tabs = std::clamp(context.settings.tabsHeight * scale, 60.0, std::max(60.0, limit));
    const float stacked = static_cast<float>(rect.height - tabs) - context.px(10);
    drawStacked(context, stacked);
    const double splitY = rect.y + rect.height - tabs - 5.0 * scale;
    const float line = static_cast<float>(splitY + 3.0 * scale);
    ImGui::GetWindowDrawList()->AddLine({edge, line}, {edge + static_cast<float>(rect.width), line},
                                        context.theme.line);
    const float dragged =
        splitter(context, "splitter/tabs", {rect.x + 6 * scale, splitY, rect.width - 6 * scale, 6.0 * scale}, false);
    if (dragged != 0.0F) {
        context.settings.tabsHeight =
            std::clamp(tabs / scale - static_cast<double>(dragged) / scale, kMinTabs, kMaxTabs);
    }
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
