#include "core/files/files.hpp"
#include "ui/canvas/picture.hpp"
#include "ui/dialogs/changed_file.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/tab_commands.hpp"
#include "ui/editor/apply_settings.hpp"
#include "ui/editor/editor_parts.hpp"
#include "ui/panels/adapted_rounds.hpp"
#include "ui/parts/preview_dialog.hpp"
#include "ui/platform/steady_seconds.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/shell/presentation.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/judging.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace forefront {

void Editor::Parts::refreshLook() {
    const double scale = context.platform.contentScale() * context.settings.scale *
                         (context.presentedFrom ? shell::kPresentedScale : 1.0);
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
    if (const Dialog *const dialog = context.dialogs.top()) {
        dialog->request(wanted);
    }
    context.run.want(wanted);
    const auto before = context.run.snapshot();
    if (newsDue() && !cancels) {
        context.run.refresh();
    }
    drewNews = before != context.run.snapshot() || newsSeconds > 0.0;
    if (const std::filesystem::path *const next = nextInTab(context); next != nullptr && reopening) {
        unproven.push_back(next->string());
        rememberSettings();
    }
    followTabs(context);
    if (recovery) {
        recovery->follow(context);
    }
    recording.follow(context);
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
    followFix(context);
    context.probe.follow(context.judgement->of.mesh ? context.judgement->of.mesh->version : 0);
    bool previewed = false;
    if (drewNews || previewDue()) {
        previewed = context.examiner.refresh();
        context.preview = context.examiner.preview();
        previewTaken = steadySeconds();
    }
    const bool planned = context.examiner.layers().refresh();
    if (before != context.run.snapshot() || previewed || judged || planned) {
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

/// Returns true while a dialog is open that previews nothing: it waits for an answer about the document shown.
bool asksInDialog(const Shell &context) {
    return context.dialogs.opening() ||
           (context.dialogs.any() && dynamic_cast<const PreviewDialog *>(context.dialogs.top()) == nullptr);
}

/// Returns true if the boundary layers of the last run are those of the document.
bool showsRunLayers(const RunControl &run) {
    return run.now().layers != nullptr && !run.outOfDate();
}

void Editor::Parts::followDocument() {
    const bool previewed = context.preview->revision == context.document.revision();
    const bool gestureOver = previewed && !ImGui::IsAnyMouseDown() && !offersDrawing(context);
    context.run.live = context.settings.live;
    context.run.liveBudget = context.settings.liveBudget;
    context.run.follow(gestureOver, hasErrors(context.preview->faults));
    // During a gesture, previews keep step with meshes: both need the same field, and are drawn together.
    if (!gestureUnderWay() || context.run.followedRevision() == context.run.meshRevision()) {
        context.examiner.submit(context.document.sharedDomain(), context.document.revision(),
                                context.document.spacing());
    }
    if (!showsLayer(context.layers, "rays") || showsRunLayers(context.run)) {
        context.examiner.layers().abandon();
    } else {
        context.examiner.layers().submit(context.document.sharedDomain(), context.document.revision(),
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
    const std::optional<FollowCamera::Subject> subject = subjectOf(context.run.now());
    if (!subject) {
        return;
    }
    constexpr double kAtOnce = 1e3;
    const double time = context.settings.reduceMotion ? kAtOnce : std::min(seconds, kLongestFrame);
    if (follower.follow(context.view, *subject, time, static_cast<double>(context.scale))) {
        context.animate();
    }
}

/// Opens dropped files, the first one in place of the drawing and the others in tabs.
void openAllDropped(Shell &context, const std::vector<std::string> &files) {
    for (std::size_t k = 0; k < files.size(); ++k) {
        if (k == 0) {
            openDropped(context, files[k]);
        } else if (isPictureName(files[k])) {
            context.log.refuse(std::filesystem::path(files[k]).filename().string() +
                               " was not added: drop a picture by itself, on the drawing that it belongs to");
        } else {
            context.tabs.waiting.push_back(files[k]);
        }
    }
}

/// Returns true if a document that is open has changes that were not saved.
bool anyUnsaved(const Shell &context) {
    for (std::size_t tab = 0; tab < context.tabs.size(); ++tab) {
        if (captionOf(context, tab).dirty) {
            return true;
        }
    }
    return false;
}

/// Ends the program as the user has closed the window. The questions about unsaved changes show other documents, which
/// must not happen below a dialog about this one.
void closeWindow(Shell &context) {
    context.dialogs.dismissPreviews(context);
    if (asksInDialog(context) && anyUnsaved(context)) {
        context.log.refuse("Close the dialog first: there are unsaved changes");
    } else if (!context.actions.run("file.quit", context)) {
        context.quit = true;
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
            openAllDropped(context, event.paths);
        } else {
            canvasInput.dispatch(event, context);
        }
    }
    if (!events.empty()) {
        context.redraw = 3;
    }
    if (std::exchange(context.closeRequested, false)) {
        closeWindow(context);
    }
}

void Editor::Parts::buildInterface() {
    const shell::Layout layout = shell::layOut(context);
    context.view.open = layout.open;
    if (context.view.resize(layout.canvas, shell::freeRoom(context, layout.open))) {
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
    const bool presents = context.presentedFrom.has_value();
    if (!presents) {
        shell::drawMenuBar(context, layout.menu);
        shell::drawTabs(context, layout.tabs);
        shell::drawOptionsBar(context, layout.options);
        shell::drawToolStrip(context, layout.tools);
    }
    shell::drawLessons(context, layout.lessons);
    shell::drawSides(context, layout.sides, layout.figures);
    shell::drawBelow(context, layout.below);
    shell::drawTimeline(context, layout.timeline);
    if (!presents) {
        shell::drawStatusBar(context, layout.status);
    }
    shell::drawRulers(context, layout);
    shell::drawCanvasNotes(context, layout.open);
    shell::drawLegendLimit(context);
    startPage.draw(context, layout.open);
    if (presents) {
        shell::drawPresentedSteps(context, layout.column);
    } else {
        shell::drawPlates(context, layout);
        shell::drawColumn(context, layout.column); // may lie over the canvas
    }
    shell::drawContextMenu(context);
    shell::drawNameField(context, layout.canvas);
    shell::drawDimensionField(context, layout.canvas);
    shell::drawFieldOffer(context);
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
    Settings settings = settingsToSave(context);
    for (const std::string &file : unproven) {
        std::erase(settings.openFiles, file);
        if (settings.lastFile == file) {
            settings.lastFile.clear();
        }
    }
    if (savedSettings != settings) {
        saveSettings(options.settingsFolder / "settings.json", settings);
        savedSettings = std::move(settings);
    }
}

} // namespace forefront
