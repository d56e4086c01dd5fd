#include "core/engine/base/diagnostic.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/shell/run_plot.hpp"
#include "ui/shell/timeline_marks.hpp"
#include "ui/widgets/shortened.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace forefront::shell {

namespace {

void drawTransport(Shell &context) {
    const bool playing = context.run.playing();
    const struct {
        const char *name, *icon, *tip, *action;
    } buttons[] = {
        {"timeline/start", icon::kToStart, "Go to the start (Home)", "run.start"},
        {"timeline/back", icon::kBack, "Step back ( , )  Shift: 100 steps", "run.back"},
        {"timeline/play", playing ? icon::kPause : icon::kPlay, playing ? "Pause (Space)" : "Play (Space)", "run.play"},
        {"timeline/forward", icon::kForward, "Step forward ( . )  Shift: 100 steps", "run.forward"},
        {"timeline/end", icon::kToEnd, "Go to the end (End)", "run.end"},
    };
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(2), 0));
    for (const auto &button : buttons) {
        const Action *action = context.actions.find(button.action);
        const bool enabled = action != nullptr && (!action->enabled || action->enabled(context));
        if (ui::iconButton(context, button.name, button.icon, button.tip, false, enabled, 30.0F)) {
            context.actions.run(button.action, context);
        }
        ImGui::SameLine();
    }
    ImGui::PopStyleVar();
}

std::string startLowered(std::string text) {
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    return text;
}

/// Returns the switches of the kinds of marks on the timeline, and that of the plots above it.
ContextGroup markSwitches(const Shell &context) {
    ContextGroup group;
    for (std::size_t k = 0; k < kMarkKinds; ++k) {
        group.push_back(switchOf("mark/" + std::to_string(k),
                                 std::string("Mark: ") + markName(static_cast<MarkKind>(k)), context.view.marks[k],
                                 [k](Shell &c) { c.view.marks[k] = !c.view.marks[k]; }));
    }
    group.push_back(switchOf("plots", "Plots of the run", context.view.runPlot,
                             [](Shell &c) { c.view.runPlot = !c.view.runPlot; }));
    return group;
}

/// Opens the menu of the timeline; on its bar, for the position under the pointer.
void openTimelineMenu(Shell &context, std::optional<std::uint64_t> position) {
    ContextGroup go;
    if (position) {
        const std::string name = startLowered(positionName(context.run.now(), *position));
        go.push_back(commandOf("goTo", "Go to " + name, [position](Shell &c) { c.run.seek(*position); }));
    }
    for (ContextItem &item : actionsOf({"run.start", "run.end", "run.nextStop", "run.previousStop"})) {
        go.push_back(std::move(item));
    }
    context.menu.open({std::move(go), actionsOf({"run.play", "run.forward", "run.back", "run.mesh", "run.cancel"}),
                       markSwitches(context)});
}

/// Draws the bar of the timeline with its marks, seeks while it is dragged, and goes to marks that are clicked.
/// Returns its scale.
TimeAxis drawScrubber(Shell &context, float width, float height) {
    const SessionSnapshot &run = context.run.now();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ui::hitArea("##scrubber", width, height);
    ui::mark(context, "timeline/scrubber", run.length() > 0);
    // The last move and the release may arrive in the same frame.
    const bool active = ImGui::IsItemActive() || ImGui::IsItemDeactivated(), hovered = ImGui::IsItemHovered();
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const Theme &theme = context.theme;
    const float middle = at.y + height / 2, half = context.px(3);
    const TimeAxis axis{at.x + context.px(7), at.x + width - context.px(7), run.length()};
    list.AddRectFilled({axis.left, middle - half}, {axis.right, middle + half}, theme.raised, half);
    if (run.length() == 0) {
        return axis;
    }
    drawMarks(context, axis, middle);
    if (run.improveSteps > 0) { // another shade for the improvement
        list.AddRectFilled({axis.x(static_cast<double>(run.known)), middle - half}, {axis.right, middle + half},
                           fade(theme.good, 0.45), half);
    }
    const float x = axis.x(static_cast<double>(run.position()));
    list.AddRectFilled({axis.left, middle - half}, {x, middle + half}, theme.accent, half);
    list.AddCircleFilled({x, middle}, context.px(active ? 7.5 : hovered ? 7.0 : 6.0), theme.text, 24);
    list.AddCircleFilled({x, middle}, context.px(3), theme.accent, 16);
    if (!active && !hovered) {
        return axis;
    }
    const std::optional<TimelineMark> mark = markUnderPointer(context, axis, middle);
    const std::uint64_t position = mark ? mark->advance : axis.positionAt(ImGui::GetIO().MousePos.x);
    if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
        openTimelineMenu(context, context.run.showsFile() ? std::nullopt : std::optional(position));
    }
    if (active && position != run.position()) {
        context.run.seek(position);
    } else if (!active) {
        ui::tooltip(context, positionName(run, position) + (mark ? ": " + startLowered(markName(mark->kind)) : ""));
    }
    return axis;
}

/// Rounds a rate to two digits, because further digits would flicker.
std::uint64_t roundedRate(double rate) {
    if (!(rate >= 1.0)) {
        return 0;
    }
    const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(rate)) - 1.0));
    return static_cast<std::uint64_t>(std::round(rate / unit) * unit);
}

std::string cancelledText(const SessionSnapshot &run) {
    if (run.known == 0) {
        return "Cancelled before there was a mesh.";
    }
    return "Cancelled after " + ui::count(run.known) +
           " advances. Step through them, press End to continue, or 2 to start again.";
}

/// Formats a fault in one line: "segments 3 and 9 cross at (2, 0.5); move a node".
std::string faultText(const Diagnostic &fault) {
    std::string text = fault.message;
    if (fault.at) {
        text += " at (" + ui::number(fault.at->x, 5) + ", " + ui::number(fault.at->y, 5) + ")";
    }
    return fault.advice.empty() ? text : text + "; " + fault.advice;
}

/// Returns a hint on how to get started while there is no mesh.
std::string invitation(const Workspace &context) {
    return context.document.current()->shapes.empty()
               ? "Draw a domain: R rectangle, P polygon, C circle. A shape inside another is a hole. Or open a file "
                 "(Ctrl+O) or a sample (Learn)."
               : "Press 2 to mesh, or Space to watch the front advance.";
}

} // namespace

/// Returns the beginning of a sentence on a finished front up to its first letter, t: in symbols where the front is
/// watched, in the workspace Step and in lessons.
std::string frontEmpty(const Shell &context) {
    const bool watched = context.settings.workspace == WorkspaceKind::Step || context.lessons.open;
    return watched ? "\xce\x93 = \xe2\x88\x85: t" : "T";
}

std::string stateText(const Shell &context) {
    const SessionSnapshot &run = context.run.now();
    if (context.run.cancelling()) {
        return "Cancelling\xe2\x80\xa6";
    }
    switch (run.state) {
    case RunState::Empty:
        return invitation(context);
    case RunState::Cancelled:
        return cancelledText(run);
    case RunState::Failed:
        if (context.run.outOfDate()) {
            return invitation(context); // the drawing has changed since it failed
        }
        return run.diagnostics.empty() ? "The domain cannot be meshed." : faultText(run.diagnostics.front());
    case RunState::Preparing:
    case RunState::Improving:
        return run.stage + "\xe2\x80\xa6";
    default:
        break;
    }
    const bool atEnd = run.atEnd();
    if (context.run.showsFile()) {
        return context.run.showsAdapted()
                   ? "A mesh of the rounds of Adapt, without its front; mesh the drawing to watch a front."
                   : "A mesh read from a file, unchanged; remesh its outline to watch the front.";
    }
    if (atEnd && context.run.outOfDate() && hasErrors(context.preview->faults)) {
        return faultText(context.preview->faults.front()); // the chip in the status bar says that it is out of date
    }
    if (atEnd && run.coarsening > 1.0) {
        return "A preview with " + ui::number(run.coarsening, 2) + " times the node spacing of the drawing.";
    }
    if (run.improvement) {
        return caption(*run.improvement, run.improveSteps);
    }
    if (run.frontDone() && run.improveSteps > 0 && run.improveStep == 0 && run.eventCursor >= run.eventCount) {
        return frontEmpty(context) + "he mesh as the front leaves it. " +
               (run.improveSteps == 1 ? std::string("One step of improvement follows.")
                                      : ui::count(run.improveSteps) + " steps of improvement follow.");
    }
    if (atEnd && (run.improved || run.frontSegments == 0) && run.eventCursor >= run.eventCount) {
        return frontEmpty(context) + "he domain is meshed" +
               std::string(run.improved ? " and the mesh improved." : ".");
    }
    if (run.explanation) {
        return stopText(run, context.run.breakpoints()) +
               caption(*run.explanation, run.eventCount > 0 ? run.eventCursor : run.explanation->events.size());
    }
    if (run.advance == 0) {
        return "\xce\x93 is the boundary of the domain; nothing is meshed yet.";
    }
    if (run.state == RunState::Running) {
        return "The front advances " + ui::count(roundedRate(run.rate)) + " times per second.";
    }
    return {};
}

namespace {

std::string positionText(const SessionSnapshot &run) {
    const auto withSteps = [](std::uint64_t advances, std::size_t steps) {
        return ui::count(advances) + (steps > 0 ? " + " + ui::count(steps) : std::string());
    };
    std::string text = withSteps(run.advance, run.improveStep) + " / " + withSteps(run.known, run.improveSteps);
    if (!run.complete && run.known > 0) {
        text += "+";
    }
    return text;
}

} // namespace

namespace {

/// Draws the caption, and the buttons at the right end of its row. `top`: y of the row.
void drawCaptionRow(Shell &context, const PixelRect &rect, float top) {
    const SessionSnapshot &run = context.run.now();
    const float right = static_cast<float>(rect.width) - context.px(14);
    ImGui::SetCursorScreenPos({right - context.px(56), top - context.px(5)});
    if (ui::iconButton(context, "timeline/plotswitch", icon::kRunPlot, "Plots of the run: front, tests, \xce\xb1",
                       context.view.runPlot, true, 26.0F)) {
        context.view.runPlot = !context.view.runPlot;
        context.animate();
    }
    ImGui::SameLine(0, context.px(4));
    drawBreakpointsButton(context);
    const std::string words = stateText(context);
    const bool fault = run.state == RunState::Failed && !context.run.outOfDate();
    const bool stopped = run.stop.has_value() || run.birth.has_value();
    ImGui::SetCursorScreenPos({context.px(14), top});
    ui::shortened(context, {static_cast<double>(context.px(14)), static_cast<double>(top)}, right - context.px(66),
                  words,
                  fault     ? context.theme.bad
                  : stopped ? context.theme.accent
                            : context.theme.text);
    ImGui::Dummy({std::max(1.0F, right - context.px(80)), ImGui::GetFontSize()});
    ui::mark(context, "timeline/caption");
}

} // namespace

void drawTimeline(Shell &context, const PixelRect &rect) {
    if (rect.height < 1.0) {
        return;
    }
    beginRegion("##timeline", rect, context.theme.panel, context.px(10), context.px(8));
    const float y = static_cast<float>(rect.y);
    ImGui::GetWindowDrawList()->AddLine({0, y}, {static_cast<float>(rect.width), y}, context.theme.line);
    const SessionSnapshot &run = context.run.now();
    const float row = context.view.runPlot ? context.px(kPlotHeight) : 0.0F;
    ImGui::SetCursorPos({context.px(10), row + context.px(8)});
    drawTransport(context);
    ImGui::SameLine(0, 0);
    const bool narrow = rect.width < static_cast<double>(context.px(760));
    const std::string position = positionText(run);
    const float right = static_cast<float>(rect.width) - context.px(14);
    const float positionWidth = std::max(ImGui::CalcTextSize(position.c_str()).x, narrow ? 0.0F : context.px(96));
    const float left = ImGui::GetCursorPosX() + context.px(narrow ? 4 : 10);
    const float width = std::max(context.px(40), right - positionWidth - context.px(10) - left);
    ImGui::SetCursorPos({left, row + context.px(10)});
    const TimeAxis axis = drawScrubber(context, width, context.px(26));
    ImGui::SetCursorPos({right - ImGui::CalcTextSize(position.c_str()).x, row + context.px(14)});
    ImGui::TextUnformatted(position.c_str());
    ui::mark(context, "timeline/position");
    drawCaptionRow(context, rect, y + row + context.px(50));
    if (context.view.runPlot) {
        drawRunPlot(context, axis, y);
    }
    if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right) && !context.menu.opens) {
        openTimelineMenu(context, std::nullopt);
    }
    ImGui::End();
}

} // namespace forefront::shell
