#include "core/drawing/shapes/shape_geometry.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/scale_dialog.hpp"
#include "ui/panels/panels.hpp"
#include "ui/parts/shell.hpp"
#include "ui/parts/shown_panels.hpp"
#include "ui/platform/assets.hpp"
#include "ui/shell/command_palette.hpp"
#include "ui/shell/help_dialogs.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/shell/pointer_hints.hpp"
#include "ui/shell/presentation.hpp"
#include "ui/shell/tool_actions.hpp"
#include "ui/workspace/judging.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

namespace forefront {

namespace {

Box2 drawingBounds(const Workspace &context) {
    Box2 box = boundsOf(*context.document.current());
    if (context.run.showsFile()) {
        box.add(context.run.now().mesh->mesh.bounds());
    }
    if (const auto &picture = context.document.current()->picture) {
        box.add(boundsOf(*picture));
    }
    return box.empty() ? Box2{{0, 0}, {10, 7}} : box;
}

void chooseTheme(Shell &context, ThemeKind kind) {
    context.settings.theme = kind;
    context.animate();
}

void addCameraActions(ActionRegistry &actions) {
    actions.add({.id = "view.fit",
                 .menu = "View",
                 .title = "Zoom to fit",
                 .shortcuts = {{'F', kNoModifiers}},
                 .run = [](Shell &c) { c.view.fit(drawingBounds(c)); }});
    actions.add({.id = "view.zoomIn",
                 .menu = "View",
                 .title = "Zoom in",
                 .shortcuts = {{key::kEqual, kNoModifiers}, {key::kEqual, kControl}},
                 .run = [](Shell &c) { c.view.zoomAt(c.view.camera.viewport.centre(), 1.4); },
                 .repeats = true});
    actions.add({.id = "view.zoomOut",
                 .menu = "View",
                 .title = "Zoom out",
                 .shortcuts = {{key::kMinus, kNoModifiers}, {key::kMinus, kControl}},
                 .run = [](Shell &c) { c.view.zoomAt(c.view.camera.viewport.centre(), 1.0 / 1.4); },
                 .repeats = true});
    actions.add({.id = "view.follow",
                 .menu = "View",
                 .title = "Follow the front",
                 .shortcuts = {{'T', kNoModifiers}},
                 .run =
                     [](Shell &c) {
                         c.view.following = !c.view.following;
                         c.animate();
                     },
                 .checked = [](const Shell &c) { return c.view.following; }});
}

void addInterfaceActions(ActionRegistry &actions) {
    actions.add({.id = "view.present",
                 .menu = "View",
                 .title = "Presentation",
                 .shortcuts = {{key::kF11, kNoModifiers}},
                 .run = shell::togglePresentation,
                 .checked = [](const Shell &c) { return c.presentedFrom.has_value(); }});
    actions.add({.id = "view.panels",
                 .menu = "View",
                 .title = "Panels",
                 .shortcuts = {{key::kTab, kNoModifiers}},
                 .run =
                     [](Shell &c) {
                         bool &shown = shell::columnFloats(c) ? c.plates.column : c.view.panels;
                         shown = !shell::columnShown(c);
                         if (shown && shell::lessonAlone(c)) {
                             c.lessons.visible = false; // the column takes its place
                         }
                         c.animate();
                     },
                 .checked = [](const Shell &c) { return shell::columnShown(c); },
                 .separatorBefore = true});
    actions.add({.id = "view.layers",
                 .menu = "View",
                 .title = "Layers",
                 .run =
                     [](Shell &c) {
                         c.plates.layers = !c.plates.layers;
                         c.animate();
                     },
                 .checked = [](const Shell &c) { return c.plates.layers; }});
    actions.add({.id = "view.log",
                 .menu = "View",
                 .title = "Log",
                 .run =
                     [](Shell &c) {
                         c.plates.log = !c.plates.log;
                         c.animate();
                     },
                 .checked = [](const Shell &c) { return c.plates.log; }});
    actions.add({.id = "view.rulers",
                 .menu = "View",
                 .title = "Rulers",
                 .shortcuts = {{'R', kControl}},
                 .run =
                     [](Shell &c) {
                         c.settings.rulers = !c.settings.rulers;
                         c.animate();
                     },
                 .checked = [](const Shell &c) { return c.settings.rulers; }});
    actions.add(
        {.id = "view.theme",
         .menu = "View",
         .title = "Light theme",
         .run =
             [](Shell &c) { chooseTheme(c, c.settings.theme == ThemeKind::Dark ? ThemeKind::Light : ThemeKind::Dark); },
         .checked = [](const Shell &c) { return c.settings.theme == ThemeKind::Light; }});
    actions.add({.id = "view.scale", .menu = "View", .title = "Interface scale\xe2\x80\xa6", .run = [](Shell &c) {
                     c.dialogs.open(std::make_unique<ScaleDialog>());
                 }});
    actions.add({.id = "view.palette",
                 .menu = "View",
                 .title = "Command palette\xe2\x80\xa6",
                 .shortcuts = {{'P', kControl}},
                 .run = [](Shell &c) { c.dialogs.open(makePalette()); },
                 .separatorBefore = true});
    actions.add({.id = "view.hints",
                 .menu = "Help",
                 .title = "Show hints",
                 .run =
                     [](Shell &c) {
                         c.settings.hints = !c.settings.hints;
                         if (c.settings.hints) {
                             renewKeys(c); // who asks for hints gets all of them
                         }
                     },
                 .checked = [](const Shell &c) { return c.settings.hints; }});
}

/// Adds the commands that choose a workspace, and those that show a panel.
void addWorkspaceActions(ActionRegistry &actions) {
    for (std::size_t k = 0; k < kWorkspaceKinds.size(); ++k) {
        const WorkspaceKind kind = kWorkspaceKinds[k];
        actions.add({.id = std::string("workspace.") + presetOf(kind).word,
                     .menu = "View",
                     .title = std::string("Workspace: ") + presetOf(kind).name,
                     .shortcuts = {{key::k0 + 1 + static_cast<int>(k), kControl}},
                     .run = [kind](Shell &c) { chooseWorkspace(c, kind); },
                     .checked = [kind](const Shell &c) { return c.settings.workspace == kind; },
                     .separatorBefore = k == 0});
    }
    for (const auto &panel : makePanels()) {
        actions.add({.id = std::string("panel.") + panel->id(),
                     .menu = "",
                     .title = std::string("Panel: ") + panel->title(),
                     .run = [id = std::string(panel->id())](Shell &c) { showPanel(c, id); }});
    }
}

bool canMesh(const Workspace &context) {
    return !context.document.current()->shapes.empty();
}

void addRunActions(ActionRegistry &actions) {
    actions.add({.id = "run.mesh",
                 .menu = "Mesh",
                 .title = "Mesh",
                 .shortcuts = {{key::k2, kNoModifiers}, {key::kF5, kNoModifiers}},
                 .run =
                     [](Shell &c) {
                         c.view.isolatedBin.reset();
                         c.run.mesh();
                     },
                 .enabled = canMesh});
    actions.add({.id = "run.cancel",
                 .menu = "Mesh",
                 .title = "Cancel",
                 .shortcuts = {{key::kEscape, kNoModifiers}},
                 .run =
                     [](Shell &c) {
                         if (c.task.busy()) {
                             cancelTask(c);
                             return;
                         }
                         c.adaptation.cancel();
                         c.run.cancel();
                     },
                 .enabled = [](const Shell &c) { return c.run.busy() || c.adaptation.busy() || c.task.busy(); }});
    actions.add({.id = "run.live",
                 .menu = "Mesh",
                 .title = "Live meshing",
                 .run = [](Shell &c) { c.settings.live = !c.settings.live; },
                 .checked = [](const Shell &c) { return c.settings.live; }});
}

/// Steps through the run, unless the mesh shown is from a file, which has no run.
void travel(Shell &context, const std::function<void(RunControl &)> &move) {
    if (context.run.showsFile()) {
        context.log.refuse("An opened mesh has no run to step through; press 2 to mesh its outline");
        return;
    }
    chooseWorkspace(context, WorkspaceKind::Step); // which has the timeline
    context.view.isolatedBin.reset();
    move(context.run);
}

/// Steps n times, backward if n is negative; says so where the run has no more steps.
void stepBy(Shell &context, std::int64_t n) {
    const SessionSnapshot &run = context.run.now();
    const bool rests = run.mesh && !context.run.busy() && !context.run.outOfDate() && !context.run.showsFile() &&
                       context.settings.workspace == WorkspaceKind::Step;
    if (rests && (n > 0 ? run.atEnd() : run.position() == 0 && run.eventCursor == 0)) {
        const std::string words = n > 0 ? "End of the run" : "Start of the run";
        const auto &said = context.log.entries();
        constexpr double kSeconds = 2.0; // a held key says it once in a while
        if (said.empty() || said.back().diagnostic.message != words ||
            context.platform.now() > said.back().time + kSeconds) {
            context.log.inform(words);
        }
        return;
    }
    travel(context, [n](RunControl &control) { control.step(control.granularity, n); });
}

bool hasStops(const Shell &context) {
    return canMesh(context) && context.run.breakpoints().any();
}

void runToStop(Shell &context, bool forward) {
    travel(context, [forward](RunControl &run) { run.seekStop(forward); });
}

void addTimelineActions(ActionRegistry &actions) {
    actions.add({.id = "run.play",
                 .menu = "Mesh",
                 .title = "Play or pause",
                 .shortcuts = {{key::kSpace, kNoModifiers}},
                 .run = [](Shell &c) { travel(c, [](RunControl &run) { run.togglePlay(); }); },
                 .enabled = canMesh,
                 .separatorBefore = true});
    const struct {
        const char *id, *title;
        Shortcut shortcut;
        std::int64_t steps;
    } steps[] = {{"run.forward", "Step forward", {key::kPeriod, kNoModifiers}, 1},
                 {"run.back", "Step back", {key::kComma, kNoModifiers}, -1},
                 {"run.forward100", "100 steps forward", {key::kPeriod, kShift}, 100},
                 {"run.back100", "100 steps back", {key::kComma, kShift}, -100}};
    for (const auto &step : steps) {
        actions.add({.id = step.id,
                     .menu = "Mesh",
                     .title = step.title,
                     .shortcuts = {step.shortcut},
                     .run = [n = step.steps](Shell &c) { stepBy(c, n); },
                     .enabled = canMesh,
                     .repeats = true});
    }
    actions.add({.id = "run.nextStop",
                 .menu = "Mesh",
                 .title = "Run to the next breakpoint",
                 .shortcuts = {{'N', kNoModifiers}},
                 .run = [](Shell &c) { runToStop(c, true); },
                 .enabled = hasStops});
    actions.add({.id = "run.previousStop",
                 .menu = "Mesh",
                 .title = "Run back to the previous breakpoint",
                 .shortcuts = {{'N', kShift}},
                 .run = [](Shell &c) { runToStop(c, false); },
                 .enabled = hasStops});
    actions.add({.id = "run.start",
                 .menu = "Mesh",
                 .title = "Go to start",
                 .shortcuts = {{key::kHome, kNoModifiers}},
                 .run = [](Shell &c) { travel(c, [](RunControl &run) { run.seek(0); }); },
                 .enabled = canMesh});
    actions.add({.id = "run.end",
                 .menu = "Mesh",
                 .title = "Go to end",
                 .shortcuts = {{key::kEnd, kNoModifiers}},
                 .run = [](Shell &c) { travel(c, [](RunControl &run) { run.seekEnd(); }); },
                 .enabled = canMesh});
}

void addPlaceActions(ActionRegistry &actions) {
    actions.add(
        {.id = "run.worst",
         .menu = "Mesh",
         .title = "Go to the worst element",
         .run =
             [](Shell &c) {
                 const Judgement &judgement = *c.judgement;
                 const bool ranked = judgement.of.mesh == c.run.now().mesh && !judgement.worst.empty();
                 const MeshPart part = infoOf(judgement.of.measure).part;
                 if (ranked && (part == MeshPart::Elements || judgement.edges)) {
                     goToRank(c, 0);
                 } else {
                     goToPart(c, {MeshPart::Elements, static_cast<std::uint32_t>(index(c.run.now().quality.worst))});
                 }
             },
         .enabled =
             [](const Shell &c) {
                 const SessionSnapshot &s = c.run.now();
                 return s.mesh && s.quality.worst != kNoElement &&
                        index(s.quality.worst) < s.mesh->view().elementCount();
             },
         .separatorBefore = true});
    actions.add({.id = "view.firstFault",
                 .menu = "",
                 .title = "Go to the first fault",
                 .run =
                     [](Shell &c) {
                         const auto &faults = c.preview->faults;
                         const auto placed = std::find_if(faults.begin(), faults.end(),
                                                          [](const Diagnostic &d) { return d.at.has_value(); });
                         if (placed != faults.end()) {
                             c.view.goTo(*placed->at, c.platform.now());
                         }
                         c.log.add(faults);
                     },
                 .enabled = [](const Shell &c) { return !c.preview->faults.empty(); }});
}

void addHelpActions(ActionRegistry &actions) {
    actions.add({.id = "help.shortcuts",
                 .menu = "Help",
                 .title = "Shortcuts",
                 .shortcuts = {{key::kF1, kNoModifiers}, {key::kSlash, kShift}},
                 .run = [](Shell &c) { c.dialogs.open(makeShortcutSheet()); }});
    actions.add({.id = "help.about",
                 .menu = "Help",
                 .title = "About Forefront",
                 .run = [](Shell &c) { c.dialogs.open(makeAbout()); },
                 .separatorBefore = true});
    actions.add({.id = "learn.samples", .menu = "Learn", .title = "All samples\xe2\x80\xa6", .run = [](Shell &c) {
                     c.actions.run("file.samples", c);
                 }});
    for (const Sample &sample : sampleDrawings()) {
        actions.add({.id = "learn." + sample.path.stem().string(),
                     .menu = "Learn",
                     .title = sample.title,
                     .run = [path = sample.path](Shell &c) { openDocument(c, path); }});
    }
}

} // namespace

void shell::addShellActions(ActionRegistry &actions) {
    shell::addToolActions(actions);
    addCameraActions(actions);
    addInterfaceActions(actions);
    addWorkspaceActions(actions);
    addRunActions(actions);
    addTimelineActions(actions);
    addPlaceActions(actions);
    shell::addLessonActions(actions);
    addHelpActions(actions);
}

} // namespace forefront
