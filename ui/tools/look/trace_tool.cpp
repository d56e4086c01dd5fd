#include "ui/tools/look/trace_tool.hpp"

#include "ui/parts/shell.hpp"
#include "ui/parts/shown_panels.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <utility>

namespace forefront {

namespace {

/// Distance within which a click means a node or an edge, in design pixels.
constexpr double kReach = 6.0;

/// Returns the cell of the background grid around a place, as shown on the canvas.
std::optional<Box2> cellAt(const SessionSnapshot &run, Vec2 place) {
    if (!run.cells) {
        return std::nullopt;
    }
    const auto found = std::find_if(run.cells->begin(), run.cells->end(),
                                    [place](const GridCellView &cell) { return cell.box.contains(place); });
    return found == run.cells->end() ? std::nullopt : std::optional(found->box);
}

} // namespace

const char *TraceTool::icon() const {
    return icon::kTrace;
}

/// The cells can be clicked only while they are shown: only then does the snapshot have them.
void TraceTool::activate(Shell &context) {
    if (context.view.traceMode == TraceMode::Cell) {
        showLayer(context.layers, "grid", true);
    }
}

bool TraceTool::handle(const CanvasEvent &event, Shell &context) {
    if (event.kind != CanvasEvent::Kind::Press || event.button != MouseButton::Left) {
        return false;
    }
    click(event.place, context);
    return true;
}

void TraceTool::click(Vec2 place, Shell &context) {
    if (context.run.showsFile()) {
        context.log.refuse("An opened mesh has no run to trace; mesh the drawing first");
        return;
    }
    Breakpoints breakpoints = context.run.breakpoints();
    switch (context.view.traceMode) {
    case TraceMode::Birth:
        chooseWorkspace(context, WorkspaceKind::Step);
        context.view.isolatedBin.reset();
        context.run.seekBirth(place, context.view.camera.length(kReach * static_cast<double>(context.scale)));
        return;
    case TraceMode::Place:
        breakpoints.place = place;
        breakpoints.set(StopKind::Place, true);
        break;
    case TraceMode::Cell:
        breakpoints.cell = cellAt(context.run.now(), place);
        breakpoints.set(StopKind::Cell, breakpoints.cell.has_value());
        break;
    }
    context.run.setBreakpoints(breakpoints);
    context.animate();
}

void TraceTool::drawOptions(Shell &context, ui::Flow &flow) {
    flow.item("mode");
    int mode = static_cast<int>(context.view.traceMode);
    const char *const names[] = {"Creation", "Point", "Cell"};
    const char *const tips[] = {"A click goes to the advance that made the element, edge or node under the pointer",
                                "A click sets a breakpoint: stop when an element covers that point",
                                "A click sets a breakpoint: stop when a search visits the cell of the background grid"};
    if (ui::segmented(context, "options/trace/mode", names, mode, 200.0F, tips)) {
        context.view.traceMode = static_cast<TraceMode>(mode);
        activate(context);
    }
}

std::vector<ContextGroup> TraceTool::menu(Shell &context, Vec2 place) {
    const auto clickAs = [place](TraceMode mode) {
        return [place, mode](Shell &c) {
            const TraceMode before = std::exchange(c.view.traceMode, mode);
            click(place, c);
            c.view.traceMode = before;
        };
    };
    ContextGroup group;
    if (context.run.hasRun() && !context.run.showsFile()) {
        group.push_back(commandOf("birth", "Go to what made this", clickAs(TraceMode::Birth)));
        group.push_back(commandOf("stopPlace", "Stop when an element covers this point", clickAs(TraceMode::Place)));
    }
    if (cellAt(context.run.now(), place)) {
        group.push_back(commandOf("stopCell", "Stop at the next visit to this cell", clickAs(TraceMode::Cell)));
    }
    if (context.run.breakpoints().any()) {
        group.push_back(commandOf("noStops", "Remove all breakpoints", [](Shell &c) {
            Breakpoints none = c.run.breakpoints();
            none.enabled = {};
            c.run.setBreakpoints(none);
        }));
    }
    return {group, actionsOf({"run.nextStop", "run.previousStop", "run.start", "run.end"})};
}

std::string TraceTool::statusText(const Shell &context) const {
    switch (context.view.traceMode) {
    case TraceMode::Birth:
        return "Click an element, edge or node to go to the advance that made it";
    case TraceMode::Place:
        return "Click a point: the run stops when an element covers it; N runs to it";
    case TraceMode::Cell:
        return "Click a cell of the background grid: the run stops at its next visit; N runs to it";
    }
    return {};
}

} // namespace forefront
