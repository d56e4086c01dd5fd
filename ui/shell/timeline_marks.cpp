#include "ui/shell/timeline_marks.hpp"

#include "core/engine/boundary/discretise.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace forefront::shell {

namespace {

struct MarkLook {
    const char *name, *tip;
    Colour colour;
    double reach; ///< height, design pixels
    bool common;
};

MarkLook lookOf(const Theme &theme, MarkKind kind) {
    switch (kind) {
    case MarkKind::NewNode:
        return {"New node", "An advance that made a node", fade(theme.accent, 0.55), 3.0, true};
    case MarkKind::Rejection:
        return {"Rejection", "An advance that tested and rejected a candidate", fade(theme.bad, 0.6), 3.0, true};
    case MarkKind::Connection:
        return {"Connection", "Two fronts joined, or a front split in two", theme.visited, 6.0, false};
    case MarkKind::Closure:
        return {"Closure", "The last element of a front", fade(theme.good, 0.7), 4.0, true};
    case MarkKind::Deferral:
        return {"Deferral", "No candidate passed: the base segment was deferred", theme.warn, 6.0, false};
    case MarkKind::Forced:
        return {"Forced", "An element made from existing nodes only, to close the front", theme.bad, 6.0, false};
    }
    return {"", "", theme.muted, 4.0, true};
}

} // namespace

std::string positionName(const SessionSnapshot &run, std::uint64_t position) {
    return position > run.known && run.improveSteps > 0 ? "Improvement " + ui::count(position - run.known)
                                                        : "Advance " + ui::count(position);
}

std::uint64_t TimeAxis::positionAt(float x) const {
    const float t = std::clamp((x - left) / (right - left), 0.0F, 1.0F);
    return static_cast<std::uint64_t>(std::llround(static_cast<double>(t) * static_cast<double>(length)));
}

const char *markName(MarkKind kind) {
    return lookOf({}, kind).name;
}

void drawMarks(Workspace &context, const TimeAxis &axis, float y) {
    const SessionSnapshot &run = context.run.now();
    if (!run.marks) {
        return;
    }
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const float top = y + context.px(6);
    std::array<float, kMarkKinds> last{};
    last.fill(-1e9F);
    for (const bool common : {true, false}) { // rare marks on top
        for (const TimelineMark &mark : *run.marks) {
            const MarkLook look = lookOf(context.theme, mark.kind);
            const auto kind = static_cast<std::size_t>(mark.kind);
            const float x = std::round(axis.x(static_cast<double>(mark.advance)));
            if (look.common != common || !context.view.marks[kind] || x < last[kind] + context.px(common ? 4 : 1)) {
                continue;
            }
            last[kind] = x;
            list.AddRectFilled({x, top}, {x + context.px(common ? 1 : 1.5), top + context.px(look.reach)}, look.colour);
        }
    }
}

std::optional<TimelineMark> markUnderPointer(const Workspace &context, const TimeAxis &axis, float y) {
    const SessionSnapshot &run = context.run.now();
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    if (!run.marks || pointer.y < y + context.px(5)) {
        return std::nullopt; // over the bar itself
    }
    std::optional<TimelineMark> found;
    for (const TimelineMark &mark : *run.marks) {
        const float away = std::abs(axis.x(static_cast<double>(mark.advance)) - pointer.x);
        const bool visible = context.view.marks[static_cast<std::size_t>(mark.kind)];
        if (visible && away <= context.px(3) && (!found || mark.kind > found->kind)) {
            found = mark;
        }
    }
    return found;
}

namespace {

/// Draws a row with a check box and, for some conditions, the value to compare with.
void drawCondition(Shell &context, Breakpoints &breakpoints, StopKind kind) {
    const std::string name = "breakpoints/" + std::to_string(static_cast<int>(kind));
    bool on = breakpoints.has(kind);
    if (ui::checkbox(context, name, stopTitle(kind), on)) {
        breakpoints.set(kind, on);
    }
    const auto field = [&](double &value, bool whole) {
        ImGui::SameLine(0, context.px(8));
        double entered = value;
        const bool changed = ui::inputNumber(context, name + "/value", entered, 64.0F) &&
                             (!whole || ui::checkWhole(context, name + "/value", entered, 0.0, 1e9));
        if (changed) {
            value = entered;
            breakpoints.set(kind, true);
        }
        return changed;
    };
    if (kind == StopKind::LowAlpha) {
        field(breakpoints.alphaBelow, false);
    } else if (kind == StopKind::FrontLength) {
        double segments = static_cast<double>(breakpoints.segments);
        if (field(segments, true)) {
            breakpoints.segments = static_cast<std::size_t>(segments);
        }
    }
}

/// Draws the row of a condition that refers to a place on the canvas, which the trace tool sets.
void drawPlacedCondition(Shell &context, Breakpoints &breakpoints, StopKind kind, bool isSet) {
    if (isSet) {
        drawCondition(context, breakpoints, kind);
        return;
    }
    const std::string name = "breakpoints/" + std::to_string(static_cast<int>(kind)) + "/pick";
    if (ui::link(context, name,
                 kind == StopKind::Place ? "Pick a point to cover\xe2\x80\xa6"
                                         : "Pick a grid cell to visit\xe2\x80\xa6")) {
        context.view.traceMode = kind == StopKind::Place ? TraceMode::Place : TraceMode::Cell;
        context.tools.choose("trace", context);
        ImGui::CloseCurrentPopup();
    }
}

void drawConditions(Shell &context) {
    Breakpoints breakpoints = context.run.breakpoints();
    ui::heading(context, "Stop when");
    for (const StopKind kind : {StopKind::Rejection, StopKind::Deferral, StopKind::Forced, StopKind::Join,
                                StopKind::Split, StopKind::Closure, StopKind::LowAlpha, StopKind::FrontLength}) {
        drawCondition(context, breakpoints, kind);
    }
    drawPlacedCondition(context, breakpoints, StopKind::Place, breakpoints.place.has_value());
    drawPlacedCondition(context, breakpoints, StopKind::Cell, breakpoints.cell.has_value());
    context.run.setBreakpoints(breakpoints);
    const bool any = breakpoints.any();
    if (ui::button(context, "breakpoints/back", "Run back", ui::ButtonKind::Plain, any)) {
        context.actions.run("run.previousStop", context);
    }
    ui::tooltip(context, "Run back to the previous breakpoint (Shift+N)");
    ImGui::SameLine();
    if (ui::button(context, "breakpoints/next", "Run to the next", ui::ButtonKind::Primary, any)) {
        context.actions.run("run.nextStop", context);
    }
    ui::tooltip(context, "Run at full speed to the next breakpoint (N)");
    ImGui::SameLine();
    if (ui::button(context, "breakpoints/clear", "Clear", ui::ButtonKind::Quiet, any)) {
        context.run.setBreakpoints({.alphaBelow = breakpoints.alphaBelow, .segments = breakpoints.segments});
    }
}

void drawLegend(Shell &context) {
    ui::heading(context, "Marks on the timeline");
    for (std::size_t k = 0; k < kMarkKinds; ++k) {
        const auto kind = static_cast<MarkKind>(k);
        const MarkLook look = lookOf(context.theme, kind);
        if (k % 2 == 1) {
            ImGui::SameLine(context.px(150));
        }
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float middle = at.y + ImGui::GetFrameHeight() / 2;
        ImGui::GetWindowDrawList()->AddRectFilled({at.x, middle - context.px(5)},
                                                  {at.x + context.px(4), middle + context.px(5)}, look.colour);
        ImGui::SetCursorScreenPos({at.x + context.px(12), at.y});
        ui::checkbox(context, "marks/" + std::to_string(k), look.name, context.view.marks[k]);
        ui::tooltip(context, look.tip);
    }
}

} // namespace

void drawBreakpointsButton(Shell &context) {
    const Breakpoints &breakpoints = context.run.breakpoints();
    const auto count = std::count(breakpoints.enabled.begin(), breakpoints.enabled.end(), true);
    const bool open = ImGui::IsPopupOpen("##breakpoints");
    if (ui::iconButton(context, "timeline/breakpoints", icon::kFlag,
                       count == 0 ? std::string("Breakpoints and marks")
                                  : "Breakpoints and marks: " + std::to_string(count) +
                                        (count == 1 ? " breakpoint is set" : " breakpoints are set"),
                       open || count > 0, true, 26.0F)) {
        ImGui::OpenPopup("##breakpoints");
    }
    const ImVec2 corner = ImGui::GetItemRectMax();
    ImGui::SetNextWindowPos({corner.x, ImGui::GetWindowPos().y - context.px(4)}, ImGuiCond_Always, {1.0F, 1.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(14), context.px(10)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(8), context.px(2)));
    if (ImGui::BeginPopup("##breakpoints")) {
        drawConditions(context);
        ImGui::Dummy({0, context.px(4)});
        drawLegend(context);
        ui::markWindow(context, "breakpoints");
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
}

namespace {

std::string birthText(const Birth &birth, const SessionSnapshot &run) {
    const std::string a = std::to_string(index(birth.a));
    switch (birth.kind) {
    case Birth::Kind::Node:
        return run.boundary && index(birth.a) < run.boundary->nodes.size()
                   ? "Node " + a + " lies on the boundary; this advance made its first element. "
                   : "This advance made node " + a + ". ";
    case Birth::Kind::Edge:
        return "This advance made the first element at edge " + a + "-" + std::to_string(index(birth.b)) + ". ";
    case Birth::Kind::Triangle:
        return birth.element == kNoElement ? "This advance meshed this place. "
                                           : "This advance made element " + std::to_string(index(birth.element)) + ". ";
    }
    return {};
}

} // namespace

std::string stopText(const SessionSnapshot &run, const Breakpoints &breakpoints) {
    if (run.birth) {
        return birthText(*run.birth, run);
    }
    if (!run.stop) {
        return {};
    }
    const Stop &stop = *run.stop;
    switch (stop.kind) {
    case StopKind::LowAlpha:
        return ui::format("\xce\xb1 is %.3f, below %s. ", stop.value, ui::number(breakpoints.alphaBelow).c_str());
    case StopKind::FrontLength:
        return "The front has " + ui::count(static_cast<std::uint64_t>(stop.value)) + " segments. ";
    default:
        return std::string(stopTitle(stop.kind)) + ". ";
    }
}

} // namespace forefront::shell
