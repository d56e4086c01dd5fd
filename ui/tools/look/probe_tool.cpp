#include "ui/tools/look/probe_tool.hpp"

#include "ui/parts/shell.hpp"
#include "ui/parts/shown_panels.hpp"
#include "ui/workspace/edit_state.hpp"
#include "ui/workspace/judging.hpp"

namespace forefront {

namespace {

constexpr double kProbeReach = 8.0; ///< of the pointer, design pixels

} // namespace

const char *ProbeTool::icon() const {
    return icon::kProbe;
}

CursorShape ProbeTool::cursor() const {
    return CursorShape::Crosshair;
}

void ProbeTool::activate(Shell &context) {
    context.probe.active = true;
}

void ProbeTool::deactivate(Shell &context) {
    context.probe.active = false;
    place_.reset();
    context.probe.hovered.reset();
    context.probe.chosen.reset();
}

bool ProbeTool::handle(const CanvasEvent &event, Shell &context) {
    Probe &probe = context.probe;
    const Judgement &judgement = *context.judgement;
    switch (event.kind) {
    case CanvasEvent::Kind::Hover:
        place_ = event.place;
        find(context);
        return true;
    case CanvasEvent::Kind::Leave:
        place_.reset();
        probe.hovered.reset();
        return false;
    case CanvasEvent::Kind::Press:
        if (event.button != MouseButton::Left) {
            return false;
        }
        probe.chosen = partAt(judgement, event.place, EditState::reach(context, kProbeReach));
        probe.rank.reset();
        return true;
    case CanvasEvent::Kind::Key:
        if (event.key == key::kEscape && probe.chosen && !event.repeated) {
            probe.chosen.reset();
            return true;
        }
        return false;
    default:
        return false;
    }
}

void ProbeTool::find(Shell &context) {
    searched_ = context.judgement;
    context.probe.hovered = partAt(*searched_, *place_, EditState::reach(context, kProbeReach));
}

void ProbeTool::drawOverlay(CanvasPainter &, Shell &context) {
    if (place_ && searched_ != context.judgement) { // another mesh has come under the pointer, which rests
        find(context);
    }
}

std::vector<ContextGroup> ProbeTool::menu(Shell &context, Vec2) {
    const Probe &probe = context.probe;
    const std::optional<MeshPick> pick = probe.chosen ? probe.chosen : probe.hovered;
    ContextGroup group;
    if (pick && context.judgement->of.mesh) {
        std::string text;
        for (const auto &[label, value] : describePart(context, *pick)) {
            text.append(label).append("\t").append(value).append("\n");
        }
        group.push_back(copyCommand("copyValues", "Copy values", text));
    }
    if (probe.chosen) {
        group.push_back(commandOf(
            "follow", "Follow the pointer", [](Shell &c) { c.probe.chosen.reset(); }, "Esc"));
    }
    group.push_back(actionOf("run.worst"));
    group.push_back(commandOf("histogram", "Show the histogram", [](Shell &c) { showPanel(c, "histogram"); }));
    return {group};
}

std::string ProbeTool::statusText(const Shell &context) const {
    if (!context.judgement->of.mesh) {
        return "There is no mesh to probe";
    }
    return context.probe.chosen ? "Esc: follow the pointer again" : "Click an element, edge or node";
}

} // namespace forefront
