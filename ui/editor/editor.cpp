#include "ui/editor/editor.hpp"

#include "core/drawing_files/documents.hpp"
#include "core/files/files.hpp"
#include "ui/dialogs/action_needs.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/open_mesh.hpp"
#include "ui/editor/apply_settings.hpp"
#include "ui/editor/cursor.hpp"
#include "ui/editor/editor_parts.hpp"
#include "ui/editor/state_file.hpp"
#include "ui/layers/layers.hpp"
#include "ui/panels/panels.hpp"
#include "ui/parts/shown_panels.hpp"
#include "ui/platform/assets.hpp"
#include "ui/platform/steady_seconds.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/tools/make_tools.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <utility>

namespace forefront {

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

namespace {

/// Returns the files to open again, in the order of their tabs, as far as they are still there; the last one is that of
/// the tab to be shown.
std::vector<std::string> reopened(const Settings &settings) {
    std::vector<std::string> files = settings.reopens ? settings.openFiles : std::vector<std::string>();
    if (settings.reopens && !settings.lastFile.empty() && (files.empty() || files.back() != settings.lastFile)) {
        files.push_back(settings.lastFile);
    }
    std::erase_if(files, [](const std::string &file) {
        std::error_code ignored;
        return !std::filesystem::is_regular_file(file, ignored);
    });
    return files;
}

} // namespace

Editor::Editor(Platform &platform, EditorSetup options)
    : parts_(std::make_unique<Parts>(platform, std::move(options))) {
    Shell &c = parts_->context;
    if (!parts_->options.settingsFolder.empty()) {
        Diagnostics faults;
        c.settings = loadSettings(parts_->options.settingsFolder / "settings.json", &faults);
        c.log.add(faults);
        c.lessons.folder = parts_->options.settingsFolder / "answers";
    }
    parts_->savedSettings = c.settings;
    c.tools.tools = makeTools();
    for (auto &layer : makeLayers()) {
        c.layers.push_back({std::move(layer), false});
    }
    c.panels = makePanels();
    addEditActions(c.actions);
    addFileMenuEnd(c.actions, parts_->recording);
    shell::addShellActions(c.actions);
    addActionNeeds(c.actions);
    applySettings(c);
    c.tools.current().activate(c);
    c.plates.start = parts_->options.startPage;
    if (parts_->options.judge) {
        chooseWorkspace(c, WorkspaceKind::Judge);
        openMesh(c, parts_->options.file);
    } else if (!parts_->options.file.empty()) {
        openDocument(c, parts_->options.file);
        c.tabs.waiting.assign(parts_->options.others.begin(), parts_->options.others.end());
    } else if (const std::vector<std::string> last = reopened(c.settings); parts_->options.reopens && !last.empty()) {
        c.settings.lastFile.clear();
        c.tabs.waiting.assign(last.begin() + 1, last.end());
        parts_->reopening = true;
        parts_->unproven = {last.front()};
        parts_->rememberSettings();
        openDocument(c, last.front());
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
    parts_->unproven.clear();
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

/// Returns true while a field, dialog or menu that is to receive the next input is about to appear or to take the
/// focus.
bool Editor::Parts::inputWaits() const {
    const bool naming = context.naming.thing && !context.naming.inPanel && context.naming.frames == 0;
    const bool dimension = context.dimensionEntry.constraint && context.dimensionEntry.frames == 0;
    return context.widgets.fields.travelling() || context.dialogs.opening() || context.menu.opens ||
           context.menuKeys.mnemonic != 0 || naming || dimension;
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
    if (p.reopening && settled()) {
        p.unproven.clear();
        p.reopening = !c.tabs.waiting.empty(); // such as while a dialog is open at the start
    }
    if (!ImGui::IsAnyItemActive()) {
        p.rememberSettings();
    }
    if (!p.options.stateFile.empty()) {
        p.reportedBusy = !settled();
        writeStateFile(p.options.stateFile, *this);
    }
}

} // namespace forefront
