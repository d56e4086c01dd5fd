#include "core/engine/base/hash.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/pipeline/run_estimate.hpp"
#include "ui/parts/shown_panels.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/widgets/shortened.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/checks_summary.hpp"
#include "ui/workspace/mesh/element_words.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront::shell {

namespace {

/// Lays out the cells of the status bar from its left end, with hairlines between them, or from its right end.
class Cells {
  public:
    Cells(Shell &context, const PixelRect &rect)
        : context_(context), rect_(rect), left_(rect.x), right_(rect.x + rect.width - 0.5 * pad()) {}

    /// Adds a cell at the left, at least `minWidth` design pixels wide, so that changing digits do not move the next
    /// ones. What reaches into the cells at the right is cut; add those first.
    void add(const std::string &name, const std::string &text, Colour colour, double minWidth = 0.0) {
        const double width =
            std::min(std::max(widthOf(text), minWidth * scale() + 2.0 * pad()), std::max(0.0, right_ - left_));
        if (left_ > rect_.x) {
            ImGui::GetWindowDrawList()->AddLine(
                {static_cast<float>(left_), static_cast<float>(rect_.y + 6.0 * scale())},
                {static_cast<float>(left_), static_cast<float>(rect_.y + rect_.height - 6.0 * scale())},
                context_.theme.line);
        }
        place(name, text, colour, left_, width);
        left_ += width;
    }
    /// Adds a cell at the right, left of those before, with a dot of another colour if there is room. Returns false if
    /// there is none.
    bool addRight(const std::string &name, const std::string &text, Colour colour, std::optional<Colour> dot = {}) {
        const double room = dot ? 14.0 * scale() : 0.0;
        const double width = widthOf(text) - pad() + room;
        if (right_ - width < left_) {
            return false;
        }
        right_ -= width;
        if (dot) {
            ImGui::GetWindowDrawList()->AddCircleFilled({static_cast<float>(right_ + 0.5 * pad() + 4.0 * scale()),
                                                         static_cast<float>(rect_.y + 0.5 * rect_.height)},
                                                        context_.px(4), *dot);
        }
        place(name, text, colour, right_, width, 0.5 * pad() + room);
        return true;
    }
    /// Returns true if the last cell was clicked.
    bool clicked(const char *name) const {
        ImGui::SetCursorScreenPos({static_cast<float>(last_.x), static_cast<float>(last_.y)});
        return ui::hitArea(name, static_cast<float>(last_.width), static_cast<float>(last_.height));
    }

  private:
    double scale() const { return static_cast<double>(context_.scale); }
    double pad() const { return 10.0 * scale(); }
    double widthOf(const std::string &text) const {
        return static_cast<double>(ImGui::CalcTextSize(text.c_str()).x) + 2.0 * pad();
    }
    void place(const std::string &name, const std::string &text, Colour colour, double x, double width,
               std::optional<double> indent = {}) {
        const double height = static_cast<double>(ImGui::GetFontSize());
        last_ = {x, rect_.y, width, rect_.height};
        ui::shortened(context_, {x + indent.value_or(pad()), rect_.y + (rect_.height - height) / 2.0},
                      static_cast<float>(x + width), text, colour);
        ui::markRect(context_, "status/" + name, last_);
    }

    Shell &context_;
    PixelRect rect_;
    PixelRect last_;
    double left_, right_;
};

std::string pointerText(const Workspace &context) {
    const View &view = context.view;
    if (!view.pointer) {
        return "x \xe2\x80\x93   y \xe2\x80\x93";
    }
    const double step = view.camera.length(1.0);
    const int pixels = std::clamp(static_cast<int>(std::ceil(-std::log10(step))), 0, 9);
    const int decimals = std::max(pixels, coordinateDecimals(context.extent.diagonal(context.document)));
    return ui::format("x %.*f   y %.*f", decimals, view.pointer->x, decimals, view.pointer->y) +
           unitSuffix(context.document.current()->unit);
}

/// Returns the width of the cell for the pointer in design pixels, in steps, so that its neighbours rarely move.
double pointerWidth(const Workspace &context, const std::string &text) {
    constexpr double kLeast = 150.0, kStep = 30.0, kPad = 20.0;
    const double width = static_cast<double>(ImGui::CalcTextSize(text.c_str()).x / context.scale) + kPad;
    return std::max(kLeast, kStep * std::ceil(width / kStep));
}

/// Rounds a predicted count to two digits, since further digits mean nothing and would flicker.
std::uint64_t roundedTo2(double count) {
    const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(count)) - 1.0));
    return static_cast<std::uint64_t>(std::round(count / unit) * unit);
}

/// Adds the progress of a run, and a button that cancels it. In the workspace Mesh it has a bar of its own.
bool addProgress(Cells &cells, Shell &context) {
    const bool cancelling = context.run.cancelling();
    if (context.settings.workspace == WorkspaceKind::Mesh || (!isMeshing(context) && !cancelling)) {
        return false;
    }
    const SessionSnapshot &run = context.run.now();
    if (cancelling) {
        cells.add("cancelling", "Cancelling\xe2\x80\xa6", context.theme.text);
        return true;
    }
    cells.add("progress",
              ui::format("%2.0f %%  ", 100.0 * std::clamp(run.progress, 0.0, 1.0)) +
                  (run.stage.empty() ? "working" : run.stage),
              context.theme.text, 150);
    cells.add("cancel", "Cancel  Esc", context.theme.accent);
    if (cells.clicked("cancel")) {
        context.actions.run("run.cancel", context);
    }
    return true;
}

/// Adds one line on the state of the run where no timeline says it.
void addState(Cells &cells, Shell &context) {
    if (addProgress(cells, context) || context.settings.workspace == WorkspaceKind::Step) {
        return;
    }
    const SessionSnapshot &run = context.run.now();
    const bool failed = run.state == RunState::Failed && !context.run.outOfDate();
    if (const std::string text = stateText(context); !text.empty()) {
        cells.add("state", text, failed ? context.theme.bad : context.theme.muted);
    }
}

/// What the mesh is to the drawing, in the words and the colour of its chip.
struct MeshChip {
    std::string text;
    Colour colour;
    const char *tip;
};

MeshChip meshChip(const Shell &context) {
    const Theme &theme = context.theme;
    const SessionSnapshot &run = context.run.now();
    if (run.state == RunState::Failed && !context.run.outOfDate()) {
        return {"meshing failed", theme.bad, "Click to mesh again"};
    }
    if (run.quality.elements == 0) {
        return {"not meshed", theme.muted, "Click to mesh (2)"};
    }
    if (context.run.showsFile()) {
        return context.run.showsAdapted()
                   ? MeshChip{"adapted mesh", theme.muted, "A mesh of the rounds of Adapt"}
                   : MeshChip{"mesh of a file", theme.muted, "A mesh read from a file, unchanged"};
    }
    if (context.run.outOfDate()) {
        return {"out of date", theme.warn, "The drawing has changed; click to mesh it again"};
    }
    if (context.run.preview()) {
        return {"coarse preview", theme.warn, "Live meshing shows a coarser mesh; click to make the whole one"};
    }
    return context.settings.live ? MeshChip{"meshed live", theme.good, "The mesh follows every change of the drawing"}
                                 : MeshChip{"up to date", theme.good, "The mesh is that of the drawing"};
}

void addMeshChip(Cells &cells, Shell &context) {
    const bool none = context.document.current()->shapes.empty() && context.run.now().mesh == nullptr;
    if (none ||
        (!context.run.outOfDate() && !unfinishedText(context).empty())) { // the checks say that it is unfinished
        return;
    }
    const MeshChip chip = meshChip(context);
    if (!cells.addRight("mesh", chip.text, context.theme.muted, chip.colour)) {
        return;
    }
    if (cells.clicked("mesh") && !context.run.showsFile()) {
        context.actions.run("run.mesh", context);
    }
    ui::tooltip(context, chip.tip);
}

/// Adds the figures of the mesh, and the predicted number of elements if that is more informative.
void addFigures(Cells &cells, Shell &context) {
    const SessionSnapshot &run = context.run.now();
    if (run.quality.elements > 0) {
        if (cells.addRight("quality", ui::format("min angle %.1f\xc2\xb0", run.quality.minAngle),
                           context.theme.muted)) {
            if (cells.clicked("quality")) {
                context.actions.run("run.worst", context);
            }
            ui::tooltip(context, run.complete && !run.atEnd()
                                     ? "Smallest angle so far; the mesh is improved at the end. Click to go to the "
                                       "worst element"
                                     : ui::format("Smallest angle; the mean shape factor is %.3f. Click to go to the "
                                                  "worst element",
                                                  run.quality.alphaMean));
        }
        if (cells.addRight("counts", elementsInShort(run.quality), context.theme.text)) {
            cells.clicked("counts");
            const bool counted = run.quality.kinds != MeshQuality{}.kinds; // not while the mesh is being made
            const bool whole = run.meshHash != 0 && run.atEnd();
            ui::tooltip(context, (counted ? elementsInWords(run.quality.kinds) : std::string("Triangles")) + ", " +
                                     ui::count(run.quality.nodes) + " nodes" +
                                     (whole ? "; hash " + toHex(run.meshHash).substr(0, 8) : std::string()));
        }
    }
    const bool quads = context.run.makesQuads();
    const double predicted = context.preview->estimatedElements / (quads ? kTrianglesPerQuad : 1.0);
    const bool differs = run.quality.elements == 0 || context.run.preview() || context.run.outOfDate();
    const std::string rounded = ui::count(roundedTo2(predicted));
    if (predicted > 0.0 && differs &&
        cells.addRight("estimate", "about " + rounded + (quads ? " quad" : " triangle") + (rounded == "1" ? "" : "s"),
                       context.theme.muted)) {
        cells.clicked("estimate");
        ui::tooltip(context, quads ? "Predicted number of quadrilaterals; it may differ where sizes change fast"
                                   : "Predicted number of triangles, within about 10 %");
    }
}

/// Adds the one verdict of all checks, of the drawing and of the mesh; a click leads to them.
void addChecks(Cells &cells, Shell &context) {
    const ChecksSummary summary = checksSummary(context);
    const bool violated = summary.state == ChecksSummary::State::Violated;
    const Theme &theme = context.theme;
    if (summary.brief.empty() || !cells.addRight("checks", summary.brief, violated ? theme.text : theme.muted,
                                                 violated        ? theme.bad
                                                 : summary.warns ? theme.warn
                                                                 : theme.good)) {
        return;
    }
    if (cells.clicked("checks")) {
        chooseWorkspace(context, WorkspaceKind::Judge);
        showPanel(context, "checks");
    }
    const Diagnostics &faults = context.preview->faults;
    ui::tooltip(context,
                summary.line + (faults.empty() ? "" : "\n" + toString(faults.front())) + "\nClick to see all checks");
}

/// Adds what the constraints of the sketch leave free; a click selects those that do not hold.
void addSketch(Cells &cells, Shell &context) {
    const SketchState *const sketch = context.preview->sketch.get();
    if (sketch == nullptr) {
        return;
    }
    const bool violated = !sketch->violated.empty();
    const std::string text = violated ? countText(sketch->violated.size(), "constraint") +
                                            (sketch->violated.size() == 1 ? " does" : " do") + " not hold"
                             : sketch->degrees == 0 ? "fully determined"
                                                    : countText(sketch->degrees, "degree") + " of freedom";
    if (!cells.addRight("sketch", text, violated ? context.theme.text : context.theme.muted,
                        violated               ? context.theme.bad
                        : sketch->degrees == 0 ? context.theme.determined
                                               : context.theme.boundary)) {
        return;
    }
    if (cells.clicked("sketch") && violated) {
        context.selection.clear();
        context.selection.constraints = sketch->violated;
        context.selection.prune(*context.document.current());
    }
    ui::tooltip(context, violated ? "Click to select these constraints"
                                  : "Number of independent movements that the constraints leave to the sketch");
}

/// Adds the badge of the log: the number of warnings and errors since it was last open, except those that a field or
/// dialog shows.
void addLog(Cells &cells, Shell &context) {
    const auto &entries = context.log.entries();
    if (context.plates.log && !entries.empty()) {
        context.logSeen = entries.back().number;
    }
    const auto news = std::count_if(entries.begin(), entries.end(), [&](const MessageLog::Entry &entry) {
        return entry.number > context.logSeen && entry.announced && entry.diagnostic.severity != Severity::Note;
    });
    const std::string text = news > 0 ? "Log  " + std::to_string(news) : "Log";
    if (!cells.addRight("log", text, news > 0 ? context.theme.warn : context.theme.muted)) {
        return;
    }
    if (cells.clicked("log")) {
        context.actions.run("view.log", context);
    }
    ui::tooltip(context, context.plates.log ? "Hide the log" : "Show the log");
}

/// Says that a script is being recorded; a click ends that.
void addRecording(Cells &cells, Shell &context) {
    if (context.recordedScript.empty() ||
        !cells.addRight("recording", "recording " + context.recordedScript, context.theme.text, context.theme.bad)) {
        return;
    }
    if (cells.clicked("recording")) {
        context.actions.run("file.recordScript", context);
    }
    ui::tooltip(context, "What you do is written to this script. Click to stop the recording");
}

/// Returns the menu of the status bar.
std::vector<ContextGroup> statusMenu(const Shell &context) {
    const SessionSnapshot &run = context.run.now();
    ContextGroup copies;
    if (run.quality.elements > 0) {
        copies.push_back(copyCommand("status/counts", "Copy numbers of elements and nodes",
                                     std::to_string(run.quality.elements) + '\t' + std::to_string(run.quality.nodes)));
        copies.push_back(copyCommand("status/quality", "Copy shape factor and smallest angle",
                                     ui::format("%.6g\t%.6g", run.quality.alphaMean, run.quality.minAngle)));
    }
    if (run.meshHash != 0 && run.atEnd()) {
        copies.push_back(copyCommand("status/hash", "Copy mesh hash", toHex(run.meshHash)));
    }
    return {std::move(copies), actionsOf({"view.firstFault"}),
            actionsOf({"view.panels", "view.rulers", "edit.preferences"})};
}

} // namespace

void drawStatusBar(Shell &context, const PixelRect &rect) {
    if (rect.height < 1.0) {
        return;
    }
    beginRegion("##status", rect, context.theme.panel, 0, 0);
    ImGui::GetWindowDrawList()->AddLine({0, static_cast<float>(rect.y)},
                                        {static_cast<float>(rect.width), static_cast<float>(rect.y)},
                                        context.theme.line);
    ImGui::PushFont(context.fonts.small);
    Cells cells(context, rect);
    const std::string pointer = pointerText(context);
    cells.add("pointer", pointer, context.theme.muted, pointerWidth(context, pointer));
    addLog(cells, context);
    addRecording(cells, context);
    addFigures(cells, context);
    addMeshChip(cells, context);
    addChecks(cells, context);
    addSketch(cells, context);
    addState(cells, context);
    ImGui::PopFont();
    if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
        context.menu.open(statusMenu(context));
    }
    ImGui::End();
}

} // namespace forefront::shell
