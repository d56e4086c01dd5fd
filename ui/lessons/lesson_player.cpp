#include "ui/lessons/lesson_player.hpp"

#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/tab_commands.hpp"
#include "ui/lessons/kept_answers.hpp"
#include "ui/lessons/lesson_answers.hpp"
#include "ui/parts/shell.hpp"
#include "ui/parts/shown_panels.hpp"
#include "ui/workspace/judging.hpp"
#include "ui/workspace/view/chosen_candidate.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Returns true if two snapshots show the same moment of the same run.
bool showSameMoment(const SessionSnapshot &a, const SessionSnapshot &b) {
    return a.shownRun == b.shownRun && a.position() == b.position() && a.eventCursor == b.eventCursor &&
           a.eventCount == b.eventCount;
}

/// Returns the task of the page, or null if its question is of another kind.
const LessonTask *taskOf(const OpenLesson &open) {
    const auto &question = open.now().question;
    return question ? std::get_if<LessonTask>(&question->answer) : nullptr;
}

void rememberProgress(Shell &context) {
    const OpenLesson &open = *context.lessons.open;
    context.settings.lessons[open.entry.id].page = open.page;
}

constexpr int kFramesToReply = 3; ///< until the pane knows the height of a reply, and has scrolled to it

/// Shows the reply to an answer just given.
void showReply(Shell &context, OpenLesson::Reply reply) {
    context.lessons.open->reply = reply;
    context.lessons.open->framesToReply = kFramesToReply;
    context.animate();
}

void showPosition(Shell &context, const LessonPosition &position) {
    context.view.isolatedBin.reset();
    if (position.atEnd) {
        context.run.mesh();
        return;
    }
    context.run.seek(position.advance);
    if (position.events > 0) {
        context.run.step(Granularity::Event, position.events);
    }
}

/// Returns true if the drawing is one that a lesson brought, and was not saved as a file.
bool showsLessonDrawing(const Shell &context) {
    return context.document.loads() == context.lessons.drawingLoaded && context.document.path().empty();
}

/// Keeps the user's drawing, if there is one, to bring it back after the lesson.
void keepDrawing(Shell &context) {
    if (!showsLessonDrawing(context) && !context.document.current()->shapes.empty()) {
        const DocumentStore &store = context.document;
        context.lessons.kept = {store.current(), store.path(), store.stamp(), store.title(), store.dirty()};
    }
}

/// Brings the user's drawing back in place of the lesson's. A lesson's drawing that was saved as a file stays.
void restoreDrawing(Shell &context) {
    const std::optional<KeptDrawing> kept = std::exchange(context.lessons.kept, std::nullopt);
    if (!kept || !showsLessonDrawing(context)) {
        return;
    }
    context.document.load(*kept->document, kept->path, kept->dirty, kept->path.empty() ? kept->title : std::string(),
                          kept->stamp);
    context.run.clear();
    context.examiner.abandon();
    context.selection.clear();
    context.view.fitPending = true;
}

/// Shows the tab with the drawing of the open lesson, if there is one.
void showTabOfLesson(Shell &context) {
    const std::optional<std::size_t> tab = context.lessons.open ? tabOfLesson(context) : std::nullopt;
    if (tab) {
        showTab(context, *tab);
    }
}

/// Does something that replaces the drawing, after asking about unsaved changes. A drawing that a lesson brought comes
/// back with its page, so its changes are dropped, unless it was saved as a file.
void afterLeaving(Shell &context, std::function<void(Shell &)> then) {
    showTabOfLesson(context);
    if (showsLessonDrawing(context)) {
        context.dialogs.dismissPreviews(context);
        then(context);
    } else {
        afterUnsaved(context, std::move(then));
    }
}

void showDocumentOf(Shell &context, OpenLesson &open) {
    const std::shared_ptr<const Document> document = documentOf(open.now());
    const bool untouched = open.document == open.now().document && open.revision == context.document.revision() &&
                           document->options == context.document.current()->options && showsOwnRun(context);
    if (!untouched) {
        if (!open.document) { // the first drawing of the lesson
            keepDrawing(context);
        }
        rememberView(context);
        context.document.load(*document, {}, false, open.entry.lesson->title);
        context.lessons.drawingLoaded = context.document.loads();
        context.run.clear();
        context.examiner.abandon();
        context.selection.clear();
    }
    open.document = open.now().document;
    open.revision = context.document.revision();
    open.runRevision = context.run.meshRevision();
}

void showLayers(Shell &context, const std::vector<std::string> &visible) {
    for (const LayerSlot &slot : context.layers) {
        const bool listed = std::find(visible.begin(), visible.end(), slot.layer->id()) != visible.end();
        showLayer(context.layers, slot.layer->id(), listed);
    }
}

void showCamera(Shell &context, const LessonCamera &camera) {
    context.view.following = false;
    if (camera.box) {
        context.view.fit(*camera.box);
        context.view.fitPending = false;
    } else {
        context.view.fitPending = true;
    }
    context.view.following = camera.follow;
}

void showColours(Shell &context, const std::optional<LessonRange> &range, const LessonColours &colours) {
    chooseFormula(context, colours);
    if (colours.any()) {
        return; // their range fits the mesh
    }
    if (range) {
        chooseMeasure(context, Measure::ShapeFactor);
        context.view.measureRange = ColourRange{range->from, range->to};
    } else if (context.view.measure == Measure::ShapeFactor) {
        context.view.measureRange.reset();
    }
}

/// Shows the panels that the page speaks of, and no others of other workspaces. Those of a page that names none are the
/// steps.
void callPanels(Shell &context, const LessonPage &page) {
    context.called.clear();
    for (const LessonHighlight &highlight : page.highlights) {
        const std::string &widget = highlight.widget;
        const std::size_t slash = widget.find('/');
        const std::string panel = widget.starts_with("panel/") ? widget.substr(slash + 1) : widget.substr(0, slash);
        const Panel *const known = findPanel(context, panel);
        if (known != nullptr && known->place() == PanelPlace::Column) {
            showPanel(context, panel);
        }
    }
    if (!page.panel.empty()) {
        showPanel(context, page.panel);
    }
    if (context.called.empty()) {
        context.called.emplace_back("steps"); // gets its room, unless the user has folded it
    }
}

void showPage(Shell &context) {
    constexpr int kFramesToReveal = 4; // until the panel that the page shows is drawn, and scrolled
    OpenLesson &open = *context.lessons.open;
    const LessonPage &page = open.now();
    open.reply = OpenLesson::Reply::None;
    open.picked.reset();
    open.typed.clear();
    open.complaint.clear();
    open.hint = page.question ? page.question->hint : "";
    open.shown = false;
    open.restored = false;
    open.before.clear();
    open.fresh = true;
    open.framesToReply = 0;
    open.tried.reset();
    open.settled = false;
    open.framesSettled = 0;
    open.framesToReveal = kFramesToReveal;
    open.arrived.reset();
    open.done.reset();
    context.view.candidate.reset();
    if (page.document) {
        showDocumentOf(context, open);
        showPosition(context, page.position);
    }
    if (page.layers) {
        showLayers(context, *page.layers);
    }
    callPanels(context, page);
    showCamera(context, page.camera);
    showColours(context, page.range, page.colours);
    rememberProgress(context);
    context.animate();
}

} // namespace

bool lessonIsElsewhere(const Shell &context) {
    return tabOfLesson(context).value_or(context.tabs.active()) != context.tabs.active();
}

bool showsOwnRun(const Shell &context) {
    const OpenLesson &open = *context.lessons.open;
    return !open.now().document ||
           (context.run.shownRevision() == open.runRevision && !context.run.showsFile() && !context.run.preview());
}

void bringBackDrawing(Shell &context) {
    goToPage(context, context.lessons.open->page);
}

namespace {

/// Puts a lesson into the list, in place of an earlier version.
void addToList(std::vector<LessonEntry> &list, const LessonEntry &entry) {
    const auto known =
        std::find_if(list.begin(), list.end(), [&](const LessonEntry &each) { return each.id == entry.id; });
    if (known != list.end()) {
        *known = entry;
    } else {
        list.push_back(entry);
    }
}

/// Opens a lesson in place of the drawing that is shown.
void openHere(Shell &context, const LessonEntry &entry) {
    afterLeaving(context, [entry](Shell &c) {
        closeLesson(c);
        if (const LearnerAnswers *const known = answersTo(c, entry.id);
            known != nullptr && !belongTo(known->given, entry)) {
            dropAnswers(c, entry.id);
        }
        addToList(c.lessons.list, entry);
        for (Diagnostic fault : pictureFaults(*entry.lesson, entry.file.string(), false)) {
            fault.severity = Severity::Warning; // the page shows the words of the image
            c.log.add(std::move(fault));
        }
        c.lessons.last = entry.id;
        c.lessons.drawingLoaded = showsLessonDrawing(c) ? c.lessons.drawingLoaded : 0; // another tab may have that
        c.tools.choose("select", c);
        OpenLesson open{.entry = entry};
        for (const LayerSlot &slot : c.layers) {
            open.layersBefore[slot.layer->id()] = slot.visible;
        }
        open.workspaceBefore = c.settings.workspace;
        open.panelsBefore = c.view.panels;
        open.coloursBefore = c.view;
        open.unitBefore = std::exchange(c.run.granularity, Granularity::Advance);
        const std::size_t page = c.settings.lessons[entry.id].page, last = entry.lesson->pages.size() - 1;
        const AnswerCount count = countKnown(c, entry.id);
        const bool finished = page >= last && count.answered + count.shown >= questionsOf(*entry.lesson);
        open.page = finished ? 0 : std::min(page, last);
        chooseWorkspace(c, WorkspaceKind::Step);
        c.lessons.open = std::move(open);
        c.lessons.visible = true;
        showPage(c);
    });
}

} // namespace

void openLesson(Shell &context, const LessonEntry &entry) {
    afterEarlierAnswers(context, entry, [entry](Shell &c) { openHere(c, entry); });
}

void closeLesson(Shell &context) {
    if (!context.lessons.open) {
        return;
    }
    showTabOfLesson(context);
    const auto quality = context.lessons.open->layersBefore.find("quality");
    if (quality != context.lessons.open->layersBefore.end() && !quality->second) {
        context.coloursBefore.reset(); // colours of a mesh that the lesson has shown do not follow it
    }
    // While the lesson is open, its layers are not kept as the user's.
    chooseWorkspace(context, context.lessons.open->workspaceBefore);
    context.called.clear();
    const OpenLesson open = *std::exchange(context.lessons.open, std::nullopt);
    for (const auto &[layer, visible] : open.layersBefore) {
        showLayer(context.layers, layer, visible);
    }
    context.view.panels = open.panelsBefore;
    context.run.granularity = open.unitBefore;
    context.view.following = false;
    if (open.coloursBefore != context.view) {
        static_cast<ColourChoice &>(context.view) = open.coloursBefore;
        context.view.isolatedBin.reset();
        context.probe.rank.reset();
    }
    restoreDrawing(context);
    context.animate();
}

void finishLesson(Shell &context) {
    if (context.lessons.open) {
        context.settings.lessons[context.lessons.open->entry.id].page = 0;
        closeLesson(context);
    }
}

void goToPage(Shell &context, std::size_t page) {
    if (!context.lessons.open || page >= context.lessons.open->entry.lesson->pages.size()) {
        return;
    }
    afterLeaving(context, [page](Shell &c) {
        if (c.lessons.open) {
            c.lessons.open->page = page;
            showPage(c);
        }
    });
}

LessonState lessonState(const Shell &context) {
    const SessionSnapshot &run = context.run.now();
    return {run, chosenCandidate(context.view, run)};
}

LessonState pageState(const Shell &context) {
    const std::shared_ptr<const SessionSnapshot> &arrived = context.lessons.open->arrived;
    const LessonState now = lessonState(context);
    return {arrived ? *arrived : now.run, now.chosen};
}

LessonState questionState(const Shell &context) {
    const OpenLesson &open = *context.lessons.open;
    if (taskOf(open) == nullptr) {
        return pageState(context);
    }
    const LessonState now = lessonState(context);
    return {open.done ? *open.done : now.run, now.chosen};
}

void answerChoice(Shell &context, std::size_t choice) {
    showTabOfLesson(context); // the answer may be about the run
    OpenLesson &open = *context.lessons.open;
    const auto &question = open.now().question;
    const auto *choices = question ? std::get_if<LessonChoices>(&question->answer) : nullptr;
    if (choices == nullptr || choice >= choices->list.size() || !open.arrived) {
        return;
    }
    open.picked = choice;
    const LessonState state = questionState(context);
    const bool right = isRight(*choices, choice, state);
    open.hint = hintAfter(*question, choice);
    recordAnswer(context, withValues(choices->list[choice].text, state), right);
    showReply(context, right ? OpenLesson::Reply::Right : OpenLesson::Reply::Wrong);
}

void answerNumber(Shell &context) {
    showTabOfLesson(context);
    OpenLesson &open = *context.lessons.open;
    const auto &question = open.now().question;
    const auto *number = question ? std::get_if<LessonNumber>(&question->answer) : nullptr;
    if (number == nullptr || open.typed.empty() || !open.arrived) {
        return;
    }
    const std::optional<double> typed = answeredNumber(open.typed);
    open.complaint = typed ? "" : "'" + open.typed + "' is not a number; expected one such as 12 or 0.5.";
    const LessonState state = questionState(context);
    const bool right = typed && isRight(*number, *typed, state);
    if (typed) {
        open.hint = hintAfter(*question, *typed, state);
        recordAnswer(context, open.typed, right);
    }
    showReply(context, right ? OpenLesson::Reply::Right : OpenLesson::Reply::Wrong);
}

void showAnswer(Shell &context) {
    showTabOfLesson(context);
    const auto &question = context.lessons.open->now().question;
    if (question && question->show) {
        context.lessons.open->shown = true;
        recordShown(context);
        showPosition(context, *question->show);
        context.animate();
    }
}

void followLesson(Shell &context) {
    if (!context.lessons.open || lessonIsElsewhere(context)) {
        return;
    }
    OpenLesson &open = *context.lessons.open;
    open.settled = open.settled || (!context.run.busy() && !context.run.hasNews());
    const std::shared_ptr<const SessionSnapshot> &now = context.run.snapshot();
    // A later snapshot of the same moment may hold more: the improved mesh, or candidates that were not copied before.
    const bool own = showsOwnRun(context);
    if (open.arrived ? showSameMoment(*open.arrived, *now) : open.settled && own) {
        open.arrived = now;
    }
    if (open.done && showSameMoment(*open.done, *now)) {
        open.done = now;
    }
    restoreAnswer(context);
    const LessonTask *const task = taskOf(open);
    if (task == nullptr || !open.settled || !own || open.isSolved()) {
        return;
    }
    const LessonState state = lessonState(context);
    if (isDone(*task, state)) {
        open.done = now;
        if (!open.shown) {
            recordAnswer(context, taskAnswer(*now), true);
        }
        showReply(context, open.shown ? OpenLesson::Reply::Shown : OpenLesson::Reply::Right);
    } else if (asksForCandidate(*task)) {
        open.reply = state.chosen ? OpenLesson::Reply::Wrong : OpenLesson::Reply::None;
        if (state.chosen && state.chosen != open.tried) {
            recordAnswer(context, candidateAnswer(*state.chosen), false);
            showReply(context, OpenLesson::Reply::Wrong);
        }
        open.tried = state.chosen;
    }
}

void revealHighlights(Shell &context) {
    context.widgets.revealed.clear();
    OpenLesson *const open = context.lessons.open ? &*context.lessons.open : nullptr;
    if (open == nullptr || !open->settled || open->framesToReveal == 0) {
        return;
    }
    --open->framesToReveal;
    for (const LessonHighlight &highlight : open->now().highlights) {
        context.widgets.revealed.insert(highlight.widget);
    }
    context.animate();
}

} // namespace forefront
