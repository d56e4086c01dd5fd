#include "ui/editor/editor.hpp"

#include "core/drawing_files/documents.hpp"
#include "core/files/files.hpp"
#include "ui/dialogs/changed_file.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/open_mesh.hpp"
#include "ui/dialogs/recovery.hpp"
#include "ui/editor/apply_settings.hpp"
#include "ui/editor/canvas_input.hpp"
#include "ui/editor/cursor.hpp"
#include "ui/editor/imgui_bridge.hpp"
#include "ui/editor/snapshot_pace.hpp"
#include "ui/editor/state_file.hpp"
#include "ui/layers/layers.hpp"
#include "ui/panels/adapted_rounds.hpp"
#include "ui/panels/panels.hpp"
#include "ui/parts/shown_panels.hpp"
#include "ui/platform/assets.hpp"
#include "ui/platform/steady_seconds.hpp"
#include "ui/shell/canvas.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/shell/start_page.hpp"
#include "ui/tools/make_tools.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/judging.hpp"
#include "ui/workspace/view/follow_camera.hpp"
#include "ui/workspace/view/moment.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace forefront {

struct Editor::Parts {
    Parts(Platform &platform, EditorSetup given)
        : options(std::move(given)), bridge(platform), context(platform), canvas(context.background) {}

    EditorSetup options;
    InputQueue input;
    ImGuiBridge bridge;
    Shell context;
    Canvas canvas;
    CanvasInput canvasInput;
    shell::StartPage startPage;
    FollowCamera follower;
    std::unique_ptr<Recovery> recovery; ///< null: no journal is kept
    Settings savedSettings;
    std::string shownTitle;
    double lastFrame = 0.0;
    std::uint64_t frames = 0;
    std::uint64_t flagRevision = 0; ///< revision of the document that the view's flag refers to
    PixelSize size;
    SnapshotPace pace;
    double lastEnd = 0.0;          ///< steady time when the last frame ended
    double previewTaken = 0.0;     ///< steady time when a preview or raster was last taken
    bool drewNews = false;         ///< this frame draws a new snapshot, or a part of it
    double newsSeconds = 0.0;      ///< that drawing the new snapshot has taken
    bool showedCancelling = false; ///< a frame that shows the cancelling has been presented
    bool drewBusy = false;         ///< the last frame showed a run as busy
    bool reportedBusy = false;     ///< the state file says that the editor has not settled

    bool newsDue() const;
    bool previewDue() const;
    bool due(NewsPace news) const;
    double untilTurn() const;
    bool gestureUnderWay() const;
    bool keySharesFrame(const InputEvent &event) const;
    void refreshLook();
    void takeResults(bool cancels);
    void dropFlag();
    void followDocument();
    void followFront(double seconds);
    void handleEvents(const std::vector<InputEvent> &events);
    void buildInterface();
    void showTitle();
    bool inputWaits() const;
    std::vector<InputEvent> takeInput();
    void recordFrame(double begin, bool cancelling, bool busy);
    void rememberSettings();
};

bool Editor::Parts::newsDue() const {
    if (context.run.cancelling() && !showedCancelling) {
        return false; // show the cancelling first: drawing the new snapshot may take long
    }
    if (canvas.pictureIncomplete()) {
        return false; // complete the picture of the last snapshot first
    }
    const RunState state = context.run.now().state;
    return pace.due(steadySeconds(), state == RunState::Running || state == RunState::Improving);
}

/// Returns true while the user drags something and a live mesh of it is being made.
bool Editor::Parts::gestureUnderWay() const {
    return context.run.live && context.run.busy() && ImGui::IsAnyMouseDown();
}

/// Returns the seconds until the next frame may be drawn for input alone. During a gesture, frames leave half of the
/// time to the mesh that follows; it is drawn as soon as it is ready.
double Editor::Parts::untilTurn() const {
    constexpr double kPeriod = 1.0 / 40.0;
    return gestureUnderWay() && !context.run.hasNews() ? lastEnd + kPeriod - steadySeconds() : 0.0;
}

/// Returns true if a new preview or raster may be drawn. During a gesture they wait for the mesh that is being made, so
/// that the still parts are drawn once for all of them, but not so long that the tint would stutter.
bool Editor::Parts::previewDue() const {
    constexpr double kLongestWait = 0.2; // seconds
    return !gestureUnderWay() || context.run.hasNews() || steadySeconds() - previewTaken > kLongestWait;
}

/// Returns true if a frame may be drawn now for results with this pace.
bool Editor::Parts::due(NewsPace news) const {
    switch (news) {
    case NewsPace::WithMesh:
        return newsDue();
    case NewsPace::WithPreview:
        return previewDue();
    default:
        return true;
    }
}

/// Keys that are held down to repeat (steps, zoom, nudges) may share a frame, unless a field, popup or dialog could
/// use them; in a field, those that write text, so that a slow frame takes all that was typed meanwhile.
bool Editor::Parts::keySharesFrame(const InputEvent &event) const {
    if (ui::typing().active) {
        return writesText(event);
    }
    const bool canvasHasKeys =
        !context.dialogs.any() && !ImGui::IsAnyItemActive() && !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    const bool isArrow = event.code >= key::kRight && event.code <= key::kUp;
    return canvasHasKeys && (isArrow || context.actions.repeats(event.code));
}

Editor::Editor(Platform &platform, EditorSetup options)
    : parts_(std::make_unique<Parts>(platform, std::move(options))) {
    Shell &c = parts_->context;
    if (!parts_->options.settingsFolder.empty()) {
        Diagnostics faults;
        c.settings = loadSettings(parts_->options.settingsFolder / "settings.json", &faults);
        c.log.add(faults);
    }
    parts_->savedSettings = c.settings;
    c.tools.tools = makeTools();
    for (auto &layer : makeLayers()) {
        c.layers.push_back({std::move(layer), false});
    }
    c.panels = makePanels();
    addEditActions(c.actions);
    shell::addShellActions(c.actions);
    applySettings(c);
    c.tools.current().activate(c);
    c.plates.start = parts_->options.startPage;
    if (parts_->options.judge) {
        chooseWorkspace(c, WorkspaceKind::Judge);
        openMesh(c, parts_->options.file);
    } else if (!parts_->options.file.empty()) {
        openDocument(c, parts_->options.file);
    } else if (parts_->options.sample) {
        openFirstSample(c);
    }
    if (!parts_->options.stateFolder.empty()) {
        parts_->recovery = std::make_unique<Recovery>(parts_->options.stateFolder);
        parts_->recovery->offer(c);
    }
}

Editor::~Editor() {
    parts_->context.platform.makeCurrent();
    parts_->bridge.activate();
    if (const auto place = parts_->context.platform.windowPlace()) {
        parts_->context.settings.window = place;
    }
    rememberView(parts_->context);
    parts_->rememberSettings();
}

Shell &Editor::context() {
    return parts_->context;
}
InputQueue &Editor::input() {
    return parts_->input;
}
std::uint64_t Editor::frames() const {
    return parts_->frames;
}
const Canvas &Editor::canvas() const {
    return parts_->canvas;
}
bool Editor::running() const {
    return !parts_->context.quit;
}

bool Editor::settled() const {
    const Shell &c = parts_->context;
    return parts_->input.empty() && !parts_->input.replaying() && c.redraw <= 0 && c.background.atRest();
}

double Editor::sleepSeconds() const {
    const Shell &c = parts_->context;
    const double untilTurn = parts_->untilTurn();
    if (c.redraw > 0 || parts_->inputWaits() || !parts_->input.empty() || parts_->input.replaying()) {
        return std::max(0.0, untilTurn);
    }
    constexpr double kUntilWorkerRests = 0.002; // the worker reports its result just before it becomes idle
    const double untilNews = c.run.hasNews()           ? parts_->pace.next() - steadySeconds()
                             : c.run.liveMeshPending() ? kUntilWorkerRests
                                                       : 0.5;
    return std::clamp(std::min(c.nextFrameAt - c.platform.now(), untilNews), 0.001, 0.5);
}

bool Editor::needsFrame() const {
    const Shell &c = parts_->context;
    return sleepSeconds() <= 0.0 || c.platform.now() >= c.nextFrameAt ||
           c.background.hasNews([this](NewsPace news) { return parts_->due(news); }) ||
           (parts_->drewBusy && !c.run.busy()) || !(c.platform.framebufferSize() == parts_->size) ||
           (parts_->reportedBusy && settled());
}

bool Editor::open(const std::filesystem::path &file) {
    ImportNotes notes;
    const Result<StampedDocument> read = readStamped(file, &notes);
    if (!read) {
        parts_->context.log.add(read.faults());
        return false;
    }
    showOpened(parts_->context, *read, notes, file);
    return true;
}

void Editor::Parts::refreshLook() {
    const double scale = context.platform.contentScale() * context.settings.scale;
    const auto wanted = static_cast<float>(std::round(scale * 64.0) / 64.0);
    const bool fonts = context.fonts.body == nullptr || wanted != context.scale;
    if (fonts) {
        context.scale = wanted;
        std::string warning;
        context.fonts = loadFonts(wanted, warning);
        if (!warning.empty() && frames == 0) {
            context.log.add(Diagnostic{.severity = Severity::Warning, .code = "missing-font", .message = warning});
        }
        bridge.fontsChanged();
        context.animate();
    }
    if (fonts || frames == 0 || context.theme.kind != context.settings.theme) {
        context.theme = makeTheme(context.settings.theme);
        applyTheme(context.theme, context.scale);
        context.animate();
    }
}

/// `cancels`: the user cancels in this frame; the next frame must show that before any new snapshot.
void Editor::Parts::takeResults(bool cancels) {
    context.log.setTime(context.platform.now());
    SnapshotLayers wanted{.mesh = false, .front = false};
    for (const LayerSlot &slot : context.layers) {
        if (slot.visible) {
            slot.layer->request(wanted);
        }
    }
    wanted.mesh = true; // the panels show its figures
    wanted.explanation = wanted.explanation || context.view.following || context.lessons.open;
    context.run.want(wanted);
    const auto before = context.run.snapshot();
    if (newsDue() && !cancels) {
        context.run.refresh();
    }
    drewNews = before != context.run.snapshot() || newsSeconds > 0.0;
    if (recovery) {
        recovery->follow(context);
    }
    if (context.sides.follow(context.run, *context.document.current())) {
        context.animate();
    }
    if (context.task.refresh()) {
        context.animate();
    }
    followPicture(context);
    followFile(context);
    // A gesture or a dialog may belong to the document that the result replaces.
    if (context.task.ready() && !ImGui::IsAnyMouseDown() && !context.dialogs.any()) {
        context.task.finish();
        context.animate();
    }
    if (followAdaptation(context)) {
        context.animate();
    }
    JudgeRequest request = judgeRequest(context);
    request.quality = context.sides.mesh() != nullptr;
    if (context.sides.judge(request)) {
        context.animate();
    }
    context.judge.submit(request);
    const bool judged = context.judge.refresh();
    context.judgement = context.judge.now();
    context.probe.follow(context.judgement->of.mesh ? context.judgement->of.mesh->version : 0);
    bool previewed = false;
    if (drewNews || previewDue()) {
        previewed = context.examiner.refresh();
        context.preview = context.examiner.preview();
        previewTaken = steadySeconds();
    }
    if (before != context.run.snapshot() || previewed || judged) {
        context.animate();
    }
}

/// Removes the mark of a fault once the document has changed.
void Editor::Parts::dropFlag() {
    if (flagRevision != context.document.revision()) {
        flagRevision = context.document.revision();
        context.view.flag.reset();
    }
}

void Editor::Parts::followDocument() {
    const bool previewed = context.preview->revision == context.document.revision();
    const bool gestureOver = previewed && !ImGui::IsAnyMouseDown();
    context.run.live = context.settings.live;
    context.run.liveBudget = context.settings.liveBudget;
    context.run.follow(gestureOver, hasErrors(context.preview->faults));
    // During a gesture, previews keep step with meshes: both need the same field, and are drawn together.
    if (!gestureUnderWay() || context.run.followedRevision() == context.run.meshRevision()) {
        context.examiner.submit(context.document.sharedDomain(), context.document.revision(),
                                context.document.spacing());
    }
}

/// `seconds`: since the last frame.
void Editor::Parts::followFront(double seconds) {
    if (!context.view.following) {
        follower.reset();
        return;
    }
    constexpr double kLongestFrame = 1.0 / 30.0; // the first frame after a pause must not jump
    const Moment moment = momentOf(context.run.now());
    if (!moment) {
        return;
    }
    const AdvanceExplanation &advance = *moment.advance;
    constexpr double kAtOnce = 1e3;
    const double time = context.settings.reduceMotion ? kAtOnce : std::min(seconds, kLongestFrame);
    if (follower.follow(context.view, {boxOf(advance), distance(advance.a, advance.b)}, time,
                        static_cast<double>(context.scale))) {
        context.animate();
    }
}

void Editor::Parts::handleEvents(const std::vector<InputEvent> &events) {
    for (const InputEvent &event : events) {
        if (event.kind == InputKind::Close) {
            context.closeRequested = true;
        } else if (event.kind == InputKind::Focus && event.pressed) {
            context.fileWatch.lookNow();
            context.pictures.lookNow();
            canvasInput.dispatch(event, context);
        } else if (event.kind == InputKind::Drop) {
            for (const std::string &path : event.paths) {
                openDropped(context, path);
            }
        } else {
            canvasInput.dispatch(event, context);
        }
    }
    if (!events.empty()) {
        context.redraw = 3;
    }
    if (context.closeRequested) {
        context.closeRequested = false;
        if (!context.actions.run("file.quit", context)) {
            context.quit = true;
        }
    }
}

void Editor::Parts::buildInterface() {
    const shell::Layout layout = shell::layOut(context);
    if (context.view.resize(layout.canvas, shell::freeRoom(context, layout.canvas))) {
        context.animate();
    }
    if (context.view.fitPending && frames >= 1) {
        context.view.fitPending = false;
        const bool following = context.view.following; // from here on, as on a page of a lesson
        const std::uint64_t jumps = context.view.jumps;
        context.actions.run("view.fit", context);
        context.view.jumps = jumps; // a drawing that was just opened appears in its place
        context.view.following = following;
    }
    ui::markRect(context, "canvas", layout.canvas);
    shell::drawMenuBar(context, layout.menu);
    shell::drawOptionsBar(context, layout.options);
    shell::drawToolStrip(context, layout.tools);
    shell::drawLessons(context, layout.lessons);
    shell::drawSides(context, layout.sides, layout.figures);
    shell::drawBelow(context, layout.below);
    shell::drawTimeline(context, layout.timeline);
    shell::drawStatusBar(context, layout.status);
    shell::drawRulers(context, layout);
    shell::drawCanvasNotes(context, layout.open);
    shell::drawLegendLimit(context);
    startPage.draw(context, layout.open);
    shell::drawPlates(context, layout);
    shell::drawColumn(context, layout.column); // may lie over the canvas
    shell::drawContextMenu(context);
    shell::drawNameField(context, layout.canvas);
    context.dialogs.draw(context);
    shell::drawShadows(context);
}

void Editor::Parts::showTitle() {
    const std::string title =
        (context.document.dirty() ? "\xe2\x80\xa2 " : "") + context.document.title() + " \xe2\x80\x93 Forefront";
    if (title != shownTitle) {
        shownTitle = title;
        context.platform.setTitle(title);
    }
}

void Editor::Parts::rememberSettings() {
    if (options.settingsFolder.empty()) {
        return;
    }
    if (Settings settings = settingsToSave(context); savedSettings != settings) {
        saveSettings(options.settingsFolder / "settings.json", settings);
        savedSettings = std::move(settings);
    }
}

/// Returns true while a field, dialog or menu that is to receive the next input is about to appear or to take the
/// focus.
bool Editor::Parts::inputWaits() const {
    const bool naming = context.naming.thing && !context.naming.inPanel && context.naming.frames == 0;
    return context.widgets.fields.travelling() || context.dialogs.opening() || context.menu.opens ||
           context.menuKeys.mnemonic != 0 || naming;
}

/// Returns the input of this frame; none while it must wait, so that no key reaches another widget than it is meant
/// for.
std::vector<InputEvent> Editor::Parts::takeInput() {
    if (inputWaits()) {
        return {};
    }
    return input.takeFrame([this](const InputEvent &event) { return keySharesFrame(event); });
}

/// Records what was presented and how long it took since `begin`. `cancelling`, `busy`: of the run in this frame.
void Editor::Parts::recordFrame(double begin, bool cancelling, bool busy) {
    showedCancelling = cancelling;
    drewBusy = busy;
    lastEnd = steadySeconds();
    if (context.run.cancelling()) {
        context.animate();
    }
    if (drewNews) {
        newsSeconds += lastEnd - begin;
        if (!canvas.pictureIncomplete()) {
            pace.recordFrame(lastEnd, std::exchange(newsSeconds, 0.0));
        }
    }
    ++frames;
}

void Editor::frame() {
    Parts &p = *parts_;
    Shell &c = p.context;
    c.platform.makeCurrent();
    p.bridge.activate();
    c.nextFrameAt = 1e300;
    --c.redraw;
    const double now = c.platform.now();
    const double begin = steadySeconds();
    const PixelSize size = c.platform.framebufferSize();
    if (!(size == p.size)) {
        p.size = size;
        c.animate();
    }
    if (size.width <= 0 || size.height <= 0) {
        return; // minimised
    }
    const std::vector<InputEvent> events = p.takeInput();
    p.refreshLook();
    const bool escape = std::any_of(events.begin(), events.end(), [](const InputEvent &event) {
        return event.kind == InputKind::Key && event.code == key::kEscape && event.pressed;
    });
    p.takeResults(escape && c.run.busy());
    const double seconds = now - std::exchange(p.lastFrame, now);
    p.bridge.beginFrame(events, seconds);
    c.widgets.beginFrame();
    p.handleEvents(events);
    p.dropFlag();
    p.followDocument();
    const bool cancelling = c.run.cancelling(), busy = c.run.busy();
    p.buildInterface();
    p.followFront(seconds);
    c.widgets.fields.committed.clear(); // commands that follow are not about it
    p.canvasInput.endFrame(c);
    p.canvas.draw(c);
    applyCursor(c, p.canvasInput.panning());
    p.bridge.endFrame();
    c.widgets.endFrame();
    c.platform.present();
    p.recordFrame(begin, cancelling, busy);
    p.showTitle();
    if (!ImGui::IsAnyItemActive()) {
        p.rememberSettings();
    }
    if (!p.options.stateFile.empty()) {
        p.reportedBusy = !settled();
        writeStateFile(p.options.stateFile, *this);
    }
}

} // namespace forefront
