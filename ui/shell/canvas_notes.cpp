#include "core/drawing/arrangement/repair/repair.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/shell/pointer_hints.hpp"
#include "ui/shell/start_page.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/popup_style.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace forefront::shell {

namespace {

constexpr ImGuiWindowFlags kFloating = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing |
                                       ImGuiWindowFlags_NoBringToFrontOnFocus;

/// A small plate on the canvas. `pivotX` and `pivotY` choose the point of the plate that lies at (x, y): 0 is left or
/// top, 1 is right or bottom.
class Plate {
  public:
    Plate(Shell &context, const char *name, double x, double y, float pivotX, float pivotY,
          ImGuiWindowFlags more = ImGuiWindowFlags_None)
        : style_(context, 12, 8, 8, 0.96) {
        ImGui::SetNextWindowPos({static_cast<float>(x), static_cast<float>(y)}, ImGuiCond_Always, {pivotX, pivotY});
        ImGui::Begin(name, nullptr, kFloating | more);
    }
    ~Plate() { ImGui::End(); }
    Plate(const Plate &) = delete;
    Plate &operator=(const Plate &) = delete;

  private:
    ui::PopupStyle style_;
};

void key(WidgetContext &context, const char *text) {
    const ImVec2 size = ImGui::CalcTextSize(text);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 pad{context.px(6), context.px(2)};
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({at.x, at.y - pad.y}, {at.x + size.x + 2 * pad.x, at.y + size.y + pad.y}, context.theme.raised,
                       context.px(4));
    list.AddText({at.x + pad.x, at.y}, context.theme.text, text);
    ImGui::Dummy({size.x + 2 * pad.x, size.y});
    ImGui::SameLine(0, context.px(6));
}

struct Hint {
    const char *key, *text;
};

/// Returns the width of a hint in the strip, with the gap after it, in pixels.
float widthOf(const WidgetContext &context, const Hint &hint) {
    return ImGui::CalcTextSize(hint.key).x + ImGui::CalcTextSize(hint.text).x + context.px(12 + 6 + 16);
}

/// Returns true once the user has made a mesh; one that is made of a drawing as it was opened does not count.
bool hasMeshed(const Shell &context) {
    const bool own = !context.settings.live || !context.document.undoLabel().empty();
    return own && context.run.now().complete && !context.run.preview() && !context.run.showsFile();
}

/// Returns true where the strip of keys says what can be done next, as long as they are not known; it would disturb a
/// tool at work, and reading.
bool offersKeys(const Shell &context) {
    const WorkspaceKind workspace = context.settings.workspace;
    return context.settings.hints && !showsStartPage(context) && !knowsKeys(context) &&
           workspace != WorkspaceKind::Step && workspace != WorkspaceKind::Judge && !context.lessons.visible &&
           !context.presentedFrom && context.tools.current().undoLabel(context).empty();
}

/// Draws as many hints as fit beside the legends, but at least two.
void drawHints(Shell &context, const PixelRect &canvas) {
    constexpr double kLeastHeight = 280.0; // design pixels; on a lower canvas they would cover the drawing
    if (!knowsKeys(context) && hasMeshed(context)) {
        retireKeys(context);
    }
    if (!offersKeys(context) || canvas.height < static_cast<double>(context.px(kLeastHeight))) {
        return;
    }
    static constexpr std::array<Hint, 5> kMeshing{
        {{"2", "mesh"}, {"Space", "play"}, {".", "step forward"}, {"B", "paint spacing"}, {"?", "all shortcuts"}}};
    static constexpr std::array<Hint, 5> kDrawing{
        {{"R", "rectangle"}, {"P", "polygon"}, {"C", "circle"}, {"Ctrl+O", "open"}, {"?", "all shortcuts"}}};
    const auto &hints = context.document.current()->shapes.empty() ? kDrawing : kMeshing;
    const double scale = static_cast<double>(context.scale);
    float room = static_cast<float>(canvas.width - (2.0 * 14.0 + bandsOf(context, canvas).legends) * scale) -
                 context.px(2 * 12 + 24); // the padding and the close button
    std::size_t shown = 0;
    while (shown < hints.size() && room >= widthOf(context, hints[shown])) {
        room -= widthOf(context, hints[shown++]);
    }
    if (shown < 2) {
        return;
    }
    const Plate plate(context, "##hints", canvas.x + 14.0 * scale, canvas.y + canvas.height - 14.0 * scale, 0.0F, 1.0F);
    for (std::size_t i = 0; i < shown; ++i) {
        key(context, hints[i].key);
        ui::muted(context, hints[i].text);
        ImGui::SameLine(0, context.px(16));
    }
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(context.px(4), 0));
    if (ui::button(context, "hints/close", icon::kCross, ui::ButtonKind::Quiet)) {
        context.settings.hints = false;
    }
    ImGui::PopStyleVar();
    ui::markWindow(context, "hints");
}

/// Returns the maximum width of a plate without its padding, in pixels.
float roomOfPlates(const WidgetContext &context, const PixelRect &canvas) {
    return static_cast<float>(canvas.width) - context.px(2 * 12 + 2 * 12);
}

/// A corner of a plate at its right: the upper one, or the lower one.
struct PlateCorner {
    Pixel at;
    float pivotY = 0.0F; ///< 0: the upper one, 1: the lower one
};

/// Returns the place of the plate: left of the buttons in the corner of the canvas if it fits there, else at the lower
/// edge, which drawings are fitted above, or below the buttons if a legend is there. Uses the rectangles of the last
/// frame.
PlateCorner cornerOfNotes(const WidgetContext &context, const PixelRect &canvas) {
    const double gap = 12.0 * static_cast<double>(context.scale), right = canvas.x + canvas.width - gap;
    const WidgetRegistry::Widget *const buttons = context.widgets.find("canvas/tools");
    const WidgetRegistry::Widget *const plate = context.widgets.find("canvas/plate");
    const double width = plate != nullptr ? plate->rect.width : 0.4 * canvas.width;
    if (buttons == nullptr) {
        return {{right, canvas.y + gap}};
    }
    if (buttons->rect.x - 1.5 * gap - width >= canvas.x) {
        return {{buttons->rect.x - 0.5 * gap, canvas.y + gap}};
    }
    const auto &widgets = context.widgets.all();
    const bool legend = std::any_of(widgets.begin(), widgets.end(), [&canvas](const auto &widget) {
        return widget.first.starts_with("canvas/legend/") && widget.second.rect.overlaps(canvas);
    });
    return legend ? PlateCorner{{right, buttons->rect.y + buttons->rect.height + 0.5 * gap}}
                  : PlateCorner{{right, canvas.y + canvas.height - gap}, 1.0F};
}

void drawOutOfDate(Shell &context, const PixelRect &canvas) {
    if (isMeshing(context) || context.run.cancelling() || context.task.busy()) {
        return; // the progress is shown
    }
    const RunState state = context.run.now().state;
    if (!context.run.outOfDate() || state == RunState::Empty || state == RunState::Failed) {
        return; // there is no mesh
    }
    const PlateCorner corner = cornerOfNotes(context, canvas);
    const Plate plate(context, "##outofdate", corner.at.x, corner.at.y, 1.0F, corner.pivotY);
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, context.theme.warn);
    const bool preview = context.run.preview() && context.run.shownRevision() == context.run.meshRevision();
    ImGui::TextUnformatted((std::string(icon::kClock) + (preview ? "  coarse preview" : "  mesh out of date")).c_str());
    ImGui::PopStyleColor();
    ui::mark(context, "canvas/outofdate");
    ImGui::SameLine(0, context.px(12));
    if (ui::button(context, "canvas/remesh", "Mesh  2", ui::ButtonKind::Primary)) {
        context.actions.run("run.mesh", context);
    }
    ui::markWindow(context, "canvas/plate");
}

void drawBar(WidgetContext &context, double progress) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size{context.px(180), context.px(6)};
    const float y = at.y + (ImGui::GetFrameHeight() - size.y) / 2;
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({at.x, y}, {at.x + size.x, y + size.y}, context.theme.raised, size.y / 2);
    const float done = size.x * static_cast<float>(std::clamp(progress, 0.03, 1.0));
    list.AddRectFilled({at.x, y}, {at.x + done, y + size.y}, context.theme.accent, size.y / 2);
    ImGui::Dummy({size.x, ImGui::GetFrameHeight()});
    ImGui::SameLine(0, context.px(10));
    ui::muted(context, ui::format("%2.0f %%", 100.0 * std::clamp(progress, 0.0, 1.0)));
}

/// Draws the progress of reading a file.
void drawTask(Shell &context, const PixelRect &canvas) {
    if (!context.task.busy()) {
        return;
    }
    const PlateCorner corner = cornerOfNotes(context, canvas);
    const Plate plate(context, "##task", corner.at.x, corner.at.y, 1.0F, corner.pivotY);
    {
        ui::Flow flow(context, roomOfPlates(context, canvas), context.px(12));
        flow.item("stage");
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(context.task.name().c_str());
        ui::mark(context, "canvas/task");
        flow.item("bar");
        drawBar(context, context.task.fraction());
        flow.item("cancel");
        if (ui::button(context, "canvas/cancel", "Cancel  Esc")) {
            context.actions.run("run.cancel", context);
        }
    }
    ui::markWindow(context, "canvas/plate");
}

/// Draws the bar of a run in the workspace Mesh; in others, the status bar has its progress.
void drawRunBar(Shell &context, const PixelRect &canvas) {
    const bool cancelling = context.run.cancelling();
    if (context.settings.workspace != WorkspaceKind::Mesh || context.task.busy() ||
        (!isMeshing(context) && !cancelling)) {
        return;
    }
    const SessionSnapshot &run = context.run.now();
    const double below = bandsOf(context, canvas).bottom * static_cast<double>(context.scale);
    const Plate plate(context, "##run", canvas.centre().x, canvas.y + canvas.height - below, 0.5F, 1.0F);
    {
        ui::Flow flow(context, roomOfPlates(context, canvas), context.px(12));
        flow.item("stage");
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(cancelling          ? "cancelling\xe2\x80\xa6"
                               : run.stage.empty() ? "working"
                                                   : run.stage.c_str());
        ui::mark(context, cancelling ? "run/cancelling" : "run/progress");
        if (!cancelling) {
            flow.item("bar");
            drawBar(context, run.progress);
            if (run.quality.elements > 0) {
                flow.item("elements");
                ImGui::AlignTextToFramePadding();
                ui::muted(context,
                          ui::count(run.quality.elements) + (run.mesh && run.mesh->whole ? " elements" : " triangles"));
            }
            flow.item("cancel");
            if (ui::button(context, "run/cancel", "Cancel  Esc")) {
                context.actions.run("run.cancel", context);
            }
        }
    }
    ui::markWindow(context, "run");
}

/// Formats "FILE, line N: MESSAGE", without the parts that are unknown.
std::string withPlace(const Diagnostic &diagnostic) {
    std::string text;
    if (!diagnostic.file.empty()) {
        text = std::filesystem::path(diagnostic.file).filename().string();
        if (diagnostic.line > 0) {
            text += ", line " + std::to_string(diagnostic.line);
        }
        text += ": ";
    }
    return text + diagnostic.message;
}

constexpr double kNewsShown = 9.0; ///< seconds

/// Returns true for a message that tells the outcome of a command, and need not be read: it goes by itself.
bool isPassing(const Diagnostic &diagnostic) {
    return diagnostic.severity == Severity::Note || diagnostic.code == "refused" ||
           diagnostic.code == "unfinished-path";
}

/// Returns true if a message is to be shown: what passes for a few seconds, warnings and errors until the user
/// dismisses them or the drawing that they are about has changed.
bool isCurrent(const Shell &context, const MessageLog::Entry &entry) {
    const Diagnostic &diagnostic = entry.diagnostic;
    if (!entry.announced || entry.number <= context.newsDismissed ||
        (diagnostic.severity != Severity::Note && entry.revision != context.document.revision())) {
        return false;
    }
    return !isPassing(diagnostic) || context.platform.now() - entry.time <= kNewsShown;
}

/// Returns the newest message to show; otherwise null. If several faults were reported at once, returns the first and
/// counts the others in `more`.
const MessageLog::Entry *newsOf(Shell &context, std::size_t &more) {
    const auto &entries = context.log.entries();
    // A warning comes back when later messages have passed; an error does not, since a success may have followed it.
    bool followed = false;
    const auto last = std::find_if(entries.rbegin(), entries.rend(), [&](const auto &entry) {
        const bool shown = isCurrent(context, entry) && !(followed && entry.diagnostic.severity == Severity::Error);
        followed = followed || entry.announced;
        return shown;
    });
    if (last == entries.rend()) {
        return nullptr;
    }
    const bool fault = last->diagnostic.severity != Severity::Note;
    if (isPassing(last->diagnostic)) {
        context.wakeAt(last->time + kNewsShown);
    }
    auto first = last;
    const auto together = [&](const MessageLog::Entry &entry) {
        return entry.announced && entry.time == last->time && entry.diagnostic.severity != Severity::Note;
    };
    while (fault && std::next(first) != entries.rend() && together(*std::next(first))) {
        ++first;
    }
    more = static_cast<std::size_t>(first - last);
    return &*first;
}

void dismissNews(Shell &context) {
    context.newsDismissed = context.log.entries().back().number;
    context.animate();
}

/// Returns true if the shapes that a fault is about can be united.
bool unites(const Shell &context, const Diagnostic &diagnostic) {
    const bool meets = diagnostic.code == "crossing-segments" || diagnostic.code == "overlapping-segments";
    const Action *const combine = meets ? context.actions.find("edit.combine") : nullptr;
    return combine != nullptr && combine->enabled(context);
}

bool mends(const Shell &context, const Diagnostic &diagnostic) {
    return repairable(diagnostic) && anyRepairable(context.preview->faults);
}

bool leadsToLog(const Shell &context, const Diagnostic &diagnostic, std::size_t more) {
    return (more > 0 || diagnostic.code == "left-out") && !context.plates.log;
}

/// Returns true if a message has no button.
bool isPlain(const Shell &context, const Diagnostic &diagnostic, std::size_t more) {
    return isPassing(diagnostic) && !diagnostic.at && !unites(context, diagnostic) && !mends(context, diagnostic) &&
           !leadsToLog(context, diagnostic, more);
}

/// Draws the buttons of a message; `more` counts the faults that followed it.
void drawNewsButtons(Shell &context, ui::Flow &flow, const Diagnostic &diagnostic, std::size_t more) {
    if (diagnostic.at) {
        flow.item("goto");
        if (ui::button(context, "canvas/error/goto", "Show")) {
            context.view.goTo(*diagnostic.at, context.platform.now());
        }
    }
    if (unites(context, diagnostic)) {
        flow.item("combine");
        if (ui::button(context, "canvas/error/combine", "Union\xe2\x80\xa6")) {
            context.actions.run("edit.combine", context);
        }
    }
    if (mends(context, diagnostic)) {
        flow.item("repair");
        if (ui::button(context, "canvas/error/repair", "Repair")) {
            context.actions.run("edit.repair", context);
        }
    }
    if (leadsToLog(context, diagnostic, more)) {
        flow.item("log");
        if (ui::button(context, "canvas/error/log", "Log")) {
            context.actions.run("view.log", context);
            dismissNews(context);
        }
        ui::tooltip(context, "Show all messages");
    }
    if (!isPassing(diagnostic)) {
        flow.item("close");
        if (ui::button(context, "canvas/error/close", icon::kCross, ui::ButtonKind::Quiet)) {
            dismissNews(context);
        }
        ui::tooltip(context, "Dismiss; the log keeps it");
    }
}

/// Draws a message at most `room` pixels wide; `more` counts the faults that followed it.
void drawMessage(WidgetContext &context, const Diagnostic &diagnostic, float room, std::size_t more) {
    const bool fault = diagnostic.severity == Severity::Error, note = diagnostic.severity == Severity::Note;
    const bool success = note && diagnostic.code != "information";
    const Theme &theme = context.theme;
    ImGui::AlignTextToFramePadding();
    const float left = ImGui::GetCursorPosX();
    ImGui::PushStyleColor(ImGuiCol_Text, fault ? theme.bad : success ? theme.good : note ? theme.muted : theme.warn);
    ImGui::TextUnformatted(fault ? icon::kError : success ? icon::kCheck : note ? icon::kInfo : icon::kWarning);
    ImGui::PopStyleColor();
    ImGui::SameLine(0, context.px(8));
    const float words = room - (ImGui::GetCursorPosX() - left);
    ImGui::BeginGroup();
    ui::wrappedText(withPlace(diagnostic), words);
    if (!diagnostic.advice.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, theme.muted);
        ui::wrappedText(diagnostic.advice, words);
        ImGui::PopStyleColor();
    }
    if (more > 0) {
        ui::muted(context, "and " + ui::count(more) + " more; see Log");
        ui::mark(context, "canvas/error/more");
    }
    ImGui::EndGroup();
    ui::mark(context, note ? "canvas/note" : "canvas/error");
}

/// Returns true if the pointer is on the plate of the news, as it was in the last frame.
bool pointerOnNews(const WidgetContext &context) {
    const WidgetRegistry::Widget *const plate = context.widgets.find("canvas/news");
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    return plate != nullptr && plate->rect.contains({static_cast<double>(pointer.x), static_cast<double>(pointer.y)});
}

/// Shows the newest message, with buttons to go to the place of a fault and to repair it. A passing note without
/// buttons lets the pointer through and pales under it: the user may be about to click what lies there.
void drawNews(Shell &context, const PixelRect &canvas) {
    std::size_t more = 0;
    const MessageLog::Entry *const entry = newsOf(context, more);
    if (entry == nullptr) {
        return;
    }
    Diagnostic diagnostic = entry->diagnostic; // a button may add to the log
    if (unites(context, diagnostic)) {
        diagnostic.advice +=
            diagnostic.advice.empty() ? "join the shapes with Union" : ", or join the shapes with Union";
    }
    const double scale = static_cast<double>(context.scale);
    const double below = bandsOf(context, canvas).bottom;
    const bool plain = isPlain(context, entry->diagnostic, more);
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, plain && pointerOnNews(context) ? 0.2F : 1.0F);
    {
        const Plate plate(context, "##news", canvas.centre().x, canvas.y + canvas.height - below * scale, 0.5F, 1.0F,
                          plain ? ImGuiWindowFlags_NoInputs : ImGuiWindowFlags_None);
        ui::Flow flow(context, roomOfPlates(context, canvas), context.px(12));
        flow.item("message");
        drawMessage(context, diagnostic, std::min(context.px(520), flow.room()), more);
        drawNewsButtons(context, flow, diagnostic, more);
        ui::markWindow(context, "canvas/news");
    }
    ImGui::PopStyleVar();
}

} // namespace

bool isMeshing(const Workspace &context) {
    const SessionSnapshot &run = context.run.now();
    return run.state == RunState::Preparing || run.state == RunState::Improving ||
           (run.state == RunState::Running && run.progress > 0.0 && !run.playing);
}

void drawCanvasNotes(Shell &context, const PixelRect &canvas) {
    drawHints(context, canvas);
    drawOutOfDate(context, canvas);
    drawTask(context, canvas);
    drawRunBar(context, canvas);
    drawNews(context, canvas);
}

} // namespace forefront::shell
