#include "ui/shell/workspace_options.hpp"

#include "core/drawing/formulas/spacing_commands.hpp"
#include "ui/panels/measure_choice.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/enum_choice.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/judging.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace forefront::shell {

namespace {

/// Returns a title and the first key of an action: "Mesh  2".
std::string withKey(const Shell &context, const char *title, const char *id) {
    const Action *const action = context.actions.find(id);
    const bool hasKey = action != nullptr && !action->shortcuts.empty();
    return hasKey ? std::string(title) + "  " + toString(action->shortcuts.front()) : std::string(title);
}

bool canRun(const Shell &context, const char *id) {
    const Action *const action = context.actions.find(id);
    return action != nullptr && (!action->enabled || action->enabled(context));
}

void drawSizeOfAll(Shell &context, ui::Flow &flow) {
    const std::shared_ptr<const Document> document = context.document.current();
    std::optional<double> size = document->spacing.size;
    flow.item("mesh/size");
    flow.label("Element size");
    if (ui::inputOptional(context, "options/mesh/size", size, document->spacing.usesAutomatic() ? "auto" : "none",
                          76.0F, NumberAddress{NumberOwner::ofSpacing(), Quantity::Size})) {
        context.applyCommand(setSize(*document, size), "Change size");
    }
    ui::tooltip(context, "Element size wherever nothing asks for smaller elements. Leave empty for automatic.");
}

void drawMeshOptions(Shell &context, ui::Flow &flow) {
    MeshingOptions options = context.document.current()->options;
    flow.item("mesh/method");
    flow.label("Method");
    ImGui::BeginGroup();
    bool changed = ui::segmented(context, "options/mesh/method", options.method, 132.0F);
    ImGui::EndGroup();
    ui::tooltip(context, "Method. Fast: up to three elements per advance. Classic: the ten steps, one element each.");
    flow.item("mesh/improve");
    flow.label("Improve");
    ImGui::BeginGroup();
    changed = ui::segmented(context, "options/mesh/improve", options.improve, 180.0F) || changed;
    ImGui::EndGroup();
    ui::tooltip(context, "Improvement of the finished mesh. Best is slower, also adds and removes interior nodes.");
    if (changed) {
        Document next = *context.document.current();
        next.options = options;
        context.document.apply(std::move(next), "Change meshing options");
    }
    drawSizeOfAll(context, flow);
    flow.item("mesh/run");
    const bool due = context.run.now().quality.elements == 0 || context.run.outOfDate();
    if (ui::button(context, "options/mesh/run", withKey(context, "Mesh", "run.mesh"),
                   due ? ui::ButtonKind::Primary : ui::ButtonKind::Plain, canRun(context, "run.mesh"))) {
        context.actions.run("run.mesh", context);
    }
    ui::tooltip(context, due ? "Mesh the drawing" : "Mesh the drawing again; the mesh is up to date");
}

void drawStepUnit(Shell &context, ui::Flow &flow) {
    flow.item("step/unit");
    flow.label("Step");
    int granularity = static_cast<int>(context.run.granularity);
    // An advance of the classic method makes one element, one of the fast method up to three.
    const bool quads = context.run.showsQuads(), fast = context.run.method() == Method::Fast;
    const char *const names[] = {"Event", quads ? "Square" : fast ? "Advance" : "Element", "Layer"};
    const char *const tips[] = {
        "One step is one event within an advance, such as a candidate or a tested segment",
        quads  ? "One step is one advance of the front: a square, half of one, or none if the base is deferred"
        : fast ? "One step is one advance of the front: up to three elements around one node"
               : "One step is one advance of the front: one element, or none if the base segment is deferred",
        "One step is one pass around the front: as many advances as the front has segments"};
    if (ui::segmented(context, "timeline/granularity", names, granularity, 190.0F, tips)) {
        context.run.granularity = static_cast<Granularity>(granularity);
    }
}

void drawSpeed(Workspace &context, ui::Flow &flow) {
    flow.item("step/speed");
    flow.label("Speed");
    const double speed = context.run.speed();
    const double slowest = std::log10(RunControl::kSlowest), span = std::log10(RunControl::kFastest) - slowest;
    double t = (std::log10(speed) - slowest) / span;
    const double rate = speed * RunControl::kAdvancesPerSecond;
    const std::string shown = ui::format(rate < 9.95 ? "%.1f/s" : "%.0f/s", rate);
    if (ui::thinSlider(context, "timeline/speed", t, shown, 96.0F, 56.0F)) {
        context.run.setSpeed(std::pow(10.0, slowest + t * span));
    }
}

void drawStepOptions(Shell &context, ui::Flow &flow) {
    drawStepUnit(context, flow);
    drawSpeed(context, flow);
    flow.item("step/follow");
    bool follows = context.view.following;
    if (ui::checkbox(context, "options/step/follow", withKey(context, "Follow", "view.follow"), follows)) {
        context.actions.run("view.follow", context);
    }
    ui::tooltip(context, "Keep the current advance in view, its base 60 to 120 pixels long");
    flow.item("step/compare");
    const bool runsBeside = context.sides.visible && context.sides.mesh() == nullptr;
    if (ui::button(context, "options/step/compare", runsBeside ? "Stop comparing" : "Compare", ui::ButtonKind::Plain,
                   canRun(context, "learn.sides"))) {
        context.actions.run("learn.sides", context);
    }
    ui::tooltip(context, "Run other grids or the other method beside the canvas, in step with it");
}

/// Draws the limit that meshes must meet by the measure that is shown, if there can be one.
void drawLimitOption(Shell &context, ui::Flow &flow) {
    const std::optional<MeshLimit> limit =
        context.view.field.empty() && !context.view.formula.any() ? limitOf(context.view.measure) : std::nullopt;
    if (!limit) {
        return;
    }
    const LimitInfo &info = limitInfo(*limit);
    std::optional<double> value = context.document.current()->limits[*limit];
    flow.item("judge/limit");
    flow.label(info.isMinimum ? "At least" : "At most");
    if (ui::inputOptional(context, "options/judge/limit", value, "no limit", 64.0F)) {
        setLimit(context, *limit, value);
    }
    ui::tooltip(context, std::string("Limit: ") + info.name + ". " + info.meaning);
}

/// Draws the buttons that step through the worst parts.
void drawWorstOption(Shell &context, ui::Flow &flow, const Judgement &judgement) {
    const std::size_t count = judgement.worst.size();
    // 0: none of them is shown.
    const std::size_t number = context.probe.chosen && context.probe.rank ? *context.probe.rank + 1 : 0;
    flow.item("judge/worst");
    flow.label("Worst");
    if (ui::iconButton(context, "options/judge/previous", icon::kBack, "Previous", false, number > 1, 24.0F)) {
        walkRanks(context, false);
    }
    ImGui::SameLine(0, context.px(4));
    ImGui::AlignTextToFramePadding();
    const std::string text = number > 0 ? ui::format("%zu of %zu", number, count) : std::to_string(count);
    ImGui::TextUnformatted(text.c_str());
    ui::mark(context, "options/judge/rank");
    ImGui::SameLine(0, context.px(4));
    if (ui::iconButton(context, "options/judge/next", icon::kForward, number > 0 ? "Next" : "Go to the worst", false,
                       number < count, 24.0F)) {
        walkRanks(context, true);
    }
}

void drawJudgeOptions(Shell &context, ui::Flow &flow) {
    // Hold a reference, since choosing a measure must not change what is drawn after it.
    const std::shared_ptr<const Judgement> judgement = context.judgement;
    flow.item("judge/measure");
    flow.label("Measure");
    drawMeasureChoice(context, "options/judge/measure", 150.0F);
    drawLimitOption(context, flow);
    if (!judgement->of.mesh || judgement->summary.count == 0) {
        return;
    }
    if (judgement->of.measure != Measure::Region) {
        flow.item("judge/range");
        flow.label("Colours");
        drawMeasureRange(context, *judgement, "options/judge");
    }
    if (!judgement->worst.empty()) {
        drawWorstOption(context, flow, *judgement);
    }
}

} // namespace

bool hasWorkspaceOptions(const Shell &context) {
    const WorkspaceKind kind = context.settings.workspace;
    return kind == WorkspaceKind::Mesh || kind == WorkspaceKind::Step || kind == WorkspaceKind::Judge;
}

void drawWorkspaceOptions(Shell &context, ui::Flow &flow) {
    switch (context.settings.workspace) {
    case WorkspaceKind::Mesh:
        drawMeshOptions(context, flow);
        break;
    case WorkspaceKind::Step:
        drawStepOptions(context, flow);
        break;
    case WorkspaceKind::Judge:
        drawJudgeOptions(context, flow);
        break;
    default:
        break;
    }
}

} // namespace forefront::shell
